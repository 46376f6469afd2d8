#include "scene/spectral.h"

#include <cmath>
#include <vector>

namespace orbs::scene {

namespace {

// The kernel is above zero in the union of these pieces.
std::vector<KernelSupport> pieces_of(const snippets::TentKernel<double>& k) {
  if (k.peak_per_nm == 0) return {};
  return {{{k.absorbed_nm - k.absorbed_reach_nm, k.absorbed_nm + k.absorbed_reach_nm},
           {k.emitted_nm - k.emitted_reach_nm, k.emitted_nm + k.emitted_reach_nm}}};
}

std::vector<KernelSupport> pieces_of(const snippets::ReradiationMatrix<double>& k) {
  const auto bin = [&](std::size_t i) {
    const double first_nm = k.first_nm + static_cast<double>(i) * k.width_nm;
    return WavelengthRange{first_nm, first_nm + k.width_nm};
  };
  std::vector<KernelSupport> pieces;
  for (std::size_t out = 0; out < k.bins; ++out)
    for (std::size_t in = 0; in < out; ++in)
      if (k.share[out * k.bins + in] > 0) pieces.push_back({bin(in), bin(out)});
  return pieces;
}

// Clips a piece to the wavelengths that have light, and to `out` above `in`.
std::optional<KernelSupport> lit(KernelSupport piece) {
  auto& [in, out] = piece;
  in.first_nm = std::fmax(in.first_nm, spectra::kShortestLight_nm);
  out.last_nm = std::fmin(out.last_nm, spectra::kLongestSeen_nm);
  in.last_nm = std::fmin(in.last_nm, out.last_nm);
  out.first_nm = std::fmax(out.first_nm, in.first_nm);
  if (!(in.first_nm < in.last_nm) || !(out.first_nm < out.last_nm)) return std::nullopt;
  return piece;
}

}  // namespace

std::optional<KernelSupport> support_of(const Reradiation& kernel) {
  std::optional<KernelSupport> all;
  for (const auto& whole : std::visit([](const auto& k) { return pieces_of(k); }, kernel)) {
    const auto piece = lit(whole);
    if (!piece) continue;
    if (!all) all = piece;
    all->in.first_nm = std::fmin(all->in.first_nm, piece->in.first_nm);
    all->in.last_nm = std::fmax(all->in.last_nm, piece->in.last_nm);
    all->out.first_nm = std::fmin(all->out.first_nm, piece->out.first_nm);
    all->out.last_nm = std::fmax(all->out.last_nm, piece->out.last_nm);
  }
  return all;
}

std::vector<double> whole_nanometres() {
  std::vector<double> out;
  for (double nm = spectra::kShortestLight_nm; nm <= spectra::kLongestSeen_nm; nm += 1) out.push_back(nm);
  return out;
}

}  // namespace orbs::scene
