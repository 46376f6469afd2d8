#pragma once

#include "importer/source.h"

#include <cstdint>
#include <string>
#include <vector>

namespace orbs::importer {

/// An accessor's numbers, element after element, those of normalised integers as shares.
struct Numbers {
  std::size_t count = 0;
  std::size_t width = 0;  // numbers of an element
  std::vector<double> values;
  const double* element(std::size_t index) const { return values.data() + index * width; }
};

/// The accessor of this index, with what a sparse one changes. `where` names it in messages: "POSITION of
/// mesh 'box'". InputError if it leads beyond its buffer, or its elements have not `width` numbers; 0: any
/// width.
Numbers read_numbers(const Source& source, int index, std::size_t width, const std::string& where);

/// As read_numbers, of whole numbers that are below `end`. InputError names the first that is not.
std::vector<std::uint32_t> read_indices(const Source& source,
                                        int accessor,
                                        std::size_t end,
                                        const std::string& where);

}  // namespace orbs::importer
