#include "tracer/light/light_guides.h"

#include "tracer/geometry/box.h"

#include <algorithm>
#include <utility>

namespace orbs::tracer {

namespace {

constexpr std::size_t kFewestTrials = 4;
// Of the mean. Those of less would only stretch the guide of the others.
constexpr float kLeastUse = 0.01F;
constexpr std::size_t kMostEmitters = 4;  // the others are left to the paths that no guide sends
constexpr std::size_t kMostGuides = 16;
constexpr std::size_t kFewestOfAGuide = 8;
// A few points of a region do not reach its rim.
constexpr float kMargin = 1.5F;

/// Trials of one emitter that are close together.
struct Cluster {
  std::vector<GuideTrial> trials;
  Box box;
  float use = 0;
};

Cluster cluster_of(std::vector<GuideTrial> trials) {
  Cluster out;
  out.trials = std::move(trials);
  for (const GuideTrial& trial : out.trials) {
    out.box.add(trial.position);
    out.use += trial.use;
  }
  return out;
}

// What a split may gain: a cluster of much use that is spread widely.
float spread(const Cluster& cluster) {
  return cluster.trials.size() < 2 * kFewestOfAGuide ? 0 : cluster.use * length(cluster.box.size());
}

std::pair<Cluster, Cluster> halves_of(Cluster cluster) {
  const Vec3f size = cluster.box.size();
  const auto along = [&](const GuideTrial& trial) {
    const Vec3f p = trial.position;
    return size.x >= size.y && size.x >= size.z ? p.x : size.y >= size.z ? p.y : p.z;
  };
  auto& trials = cluster.trials;
  std::stable_sort(trials.begin(), trials.end(),
                   [&](const GuideTrial& a, const GuideTrial& b) { return along(a) < along(b); });
  const auto middle = trials.begin() + static_cast<std::ptrdiff_t>(trials.size() / 2);
  return {cluster_of({trials.begin(), middle}), cluster_of({middle, trials.end()})};
}

// One for each of the emitters of most use.
std::vector<Cluster> clusters_of_emitters(std::vector<GuideTrial> trials) {
  std::stable_sort(trials.begin(), trials.end(),
                   [](const GuideTrial& a, const GuideTrial& b) { return a.emitter < b.emitter; });
  std::vector<Cluster> out;
  for (auto first = trials.begin(); first != trials.end();) {
    const auto last = std::find_if(first, trials.end(),
                                   [&](const GuideTrial& trial) { return trial.emitter != first->emitter; });
    out.push_back(cluster_of({first, last}));
    first = last;
  }
  std::stable_sort(out.begin(), out.end(), [](const Cluster& a, const Cluster& b) { return a.use > b.use; });
  if (out.size() > kMostEmitters) out.resize(kMostEmitters);
  return out;
}

}  // namespace

std::vector<LightGuide> make_light_guides(const std::vector<GuideTrial>& trials) {
  float total = 0;
  for (const GuideTrial& trial : trials) total += trial.use;
  const float least = kLeastUse * total / static_cast<float>(trials.size());
  std::vector<GuideTrial> useful;
  for (const GuideTrial& trial : trials)
    if (trial.use > least) useful.push_back(trial);
  if (useful.size() < kFewestTrials) return {};
  auto clusters = clusters_of_emitters(std::move(useful));
  while (clusters.size() < kMostGuides) {
    const auto widest =
        std::max_element(clusters.begin(), clusters.end(),
                         [](const Cluster& a, const Cluster& b) { return spread(a) < spread(b); });
    if (!(spread(*widest) > 0)) break;
    auto [one, other] = halves_of(std::move(*widest));
    *widest = std::move(one);
    clusters.push_back(std::move(other));
  }
  float sum = 0;
  for (const Cluster& cluster : clusters) sum += cluster.use;
  std::vector<LightGuide> out;
  for (const Cluster& cluster : clusters) {
    out.push_back({cluster.trials.front().emitter,
                   {cluster.box.centre(), kMargin * length(cluster.box.size()) / 2},
                   (1 - kUnguidedShare) * cluster.use / sum});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const LightGuide& a, const LightGuide& b) { return a.emitter < b.emitter; });
  return out;
}

const LightGuide* pick_guide(const std::vector<LightGuide>& guides, float u) {
  for (const LightGuide& guide : guides) {
    if (u < guide.probability) return &guide;
    u -= guide.probability;
  }
  return nullptr;
}

}  // namespace orbs::tracer
