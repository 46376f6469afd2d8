#include "judge/diagnosis.h"

#include "image/colour.h"
#include "judge/fault_fit.h"
#include "metrics/psnr.h"
#include "results/target_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

struct Tried {
  CandidateFault fault;
  Fit fit;
};

double left(const Tried& tried) { return tried.fit.before > 0 ? tried.fit.after / tried.fit.before : 1; }

// The best fault of each kind, the best of all first.
std::vector<Tried> best_of_kinds(const FitSamples& samples, const FaultSubject& subject) {
  std::vector<Tried> best;
  for_each_candidate(subject, [&](CandidateFault&& fault) {
    Tried tried{std::move(fault), {}};
    tried.fit = fit_of(samples, tried.fault.like, tried.fault.known);
    const auto same = std::find_if(best.begin(), best.end(), [&](const auto& one) {
      return faults::is_same_kind(one.fault.fault, tried.fault.fault);
    });
    if (same == best.end()) {
      best.push_back(std::move(tried));
    } else if (left(tried) < left(*same)) {
      *same = std::move(tried);
    }
  });
  std::stable_sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return left(a) < left(b); });
  return best;
}

Rectangle common_of(const Rectangle& a, const Rectangle& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

double psnr_srgb8(const image::Image& a,
                  const image::Image& b,
                  const FitSamples& samples,
                  const Rectangle& where) {
  double sum = 0;
  std::size_t count = 0;
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
      if (samples.weight[pixel] <= 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto shown = [&](const image::Image& image) {
          return 255 * static_cast<double>(image::srgb_encode(std::clamp(image.at(x, y, c), 0.0F, 1.0F)));
        };
        const double d = shown(a) - shown(b);
        sum += d * d;
        ++count;
      }
    }
  return metrics::psnr_db(255, count == 0 ? 0 : sum / static_cast<double>(count));
}

}  // namespace

std::optional<Diagnosis> diagnosed(const FaultSubject& subject) {
  constexpr double kLeastShare = 0.9;
  constexpr double kDeviations = 6;
  constexpr double kDeviationsApart = 4;
  constexpr double kLeastApart = 0.02;
  const auto samples = fit_samples(subject.result, subject.reference, subject.mask);
  const auto best = best_of_kinds(samples, subject);
  if (best.empty()) return std::nullopt;
  const auto& [fault, fit] = best.front();
  const double explained = fit.before - fit.after;
  const auto rest = unexplained_by(samples, fault.like, fault.known, fault.averages_noise);
  const double share = explained / (explained + rest.squared);
  if (!(explained > 0) || share < kLeastShare || explained < kDeviations * fit.standard_error ||
      explained < 2 * 4 * rest.doubt)
    return std::nullopt;
  for (std::size_t i = 1; i < best.size(); ++i) {
    const auto apart =
        advantage(samples, best[i].fault.like, fault.like, common_of(best[i].fault.known, fault.known));
    if (apart.value <
        std::max({kLeastApart * explained, rest.squared, kDeviationsApart * apart.standard_error}))
      return std::nullopt;
  }
  const double psnr_db = fault.undone ? psnr_srgb8(*fault.undone, samples.reference, samples, fault.known)
                                      : psnr_srgb8(samples.result, fault.like, samples, fault.known);
  return Diagnosis{
      fault.fault, fault.text, psnr_db, share, fault.undone.value_or(fault.like), fault.undone.has_value()};
}

std::string diagnosis_text(const std::optional<Diagnosis>& diagnosis) {
  if (!diagnosis) return std::string(results::kNoUsualFault);
  if (std::isinf(diagnosis->psnr_db)) return fmt::format("{}: else equal to the reference", diagnosis->text);
  return fmt::format("{}: then {:.1f} dB", diagnosis->text, diagnosis->psnr_db);
}

}  // namespace orbs::judge
