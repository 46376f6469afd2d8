#pragma once

#include "studies/bench/bench.h"
#include "studies/seed_statistics.h"

#include <optional>
#include <vector>

/// What follows from the times of a bench. A number that the times are too short for is missing, never made
/// up.
namespace orbs::studies {

/// CPU seconds of the large render's samples alone, by difference, one value per round; nothing where the
/// difference is not above 0.
std::vector<std::optional<double>> sample_cpu_seconds(const BenchRenderer& renderer);

/// Camera paths per CPU second, which is the rate of one thread.
std::optional<Spread> paths_per_cpu_second(const BenchRecord& record, const BenchRenderer& renderer);

/// Camera paths per second of wall clock, with all threads.
std::optional<Spread> paths_per_second(const BenchRecord& record, const BenchRenderer& renderer);

/// CPU seconds of a process besides its samples: start, reading, building, writing.
std::optional<Spread> start_cpu_seconds(const BenchRenderer& renderer);

std::optional<Spread> traversal_share(const BenchRenderer& renderer);

/// How much faster `one` is than `other` in camera paths per CPU second, round by round.
std::optional<Spread> speed_ratio(const BenchRenderer& one, const BenchRenderer& other);

/// The noise when samples are added or taken away until they cost `cpu_seconds`: its power goes as 1 / n.
/// Stratified samples converge faster, so this flatters whoever is slower than the renderer that sets the
/// time.
std::optional<SeedNoise> noise_at(const BenchRenderer& renderer, double cpu_seconds);

/// The CPU time at which the renderers are compared: that of the first one's large render.
std::optional<double> equal_cpu_seconds(const BenchRecord& record);

/// Median of what the harness adds to a render, in milliseconds; nothing before it is measured.
std::optional<double> overhead_ms(const BenchRecord& record);

/// The most that watching took of one core during a large render of any renderer, as a share of the render's
/// wall time.
std::optional<double> watching_share(const BenchRecord& record);

}  // namespace orbs::studies
