#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What is known about gates because it was tried (format "orbs-qualification/2"): which faults of an image
/// each one rejects, and the smallest that it sees.
namespace orbs::results {

/// Name of the file beside the references, which it is about: "qualification.json", or
/// "qualification-1-4.json" for gates on images of the size "1/4".
std::string qualification_file(const std::string& size);

/// One faulty mutant of a control image.
struct MutantRecord {
  std::string fault;     // "black", "1 px to the right", ...
  std::string no_fault;  // why it is none here ("R, G and B are equal in every pixel"); "" when it is one
  bool rejected = false;
  std::string reason;  // of the verdict
};

/// The smallest size of a fault, found by bisection; nothing where the largest that was tried is not enough.
struct SmallestFault {
  std::optional<double> seen;      // the record says so, as a remark at least
  std::optional<double> rejected;  // the verdict is that the image is wrong
};

/// The gate of one image of a case.
struct GateRecord {
  std::string case_name;
  std::string target;
  std::string judged_by;                       // hash of the case and the references of the image
  std::map<std::string, std::string> control;  // provenance of the control image: program, spp, seed
  bool accepts_control = false;
  std::string control_reason;
  std::vector<MutantRecord> mutants;
  /// Share of light that is too much everywhere.
  SmallestFault global;
  /// Radiance that leaks into 16 x 16 px, over the mean of the reference.
  SmallestFault local;
  std::vector<int> local_where;                   // x0, y0, x1, y1 of these pixels
  std::map<std::string, std::string> provenance;  // "program", "version", "commit", "date", ...
};

/// True when the gate accepts the control image and rejects every mutant that is a fault.
bool is_qualified(const GateRecord& gate);

/// Reads the file; nothing in it when there is none. InputError with file, line and key.
std::vector<GateRecord> read_qualification(const std::filesystem::path& file);

/// The text of the file.
std::string qualification_json(const std::vector<GateRecord>& gates);

}  // namespace orbs::results
