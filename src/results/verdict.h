#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace orbs::results {

/// The verdict on one target by one renderer, from best to worst. Several targets together get the worst
/// verdict among them.
enum class Verdict {
  Pass,
  PassWithRemarks,   // every limit is kept, and a test sees an error for certain
  Unsupported,       // the renderer does not declare it, or cannot be given the scene
  Skipped,           // the run ended before its turn
  Inconclusive,      // the gate cannot tell: too much noise, or a reference that does not show its subject
  MissingReference,  // nothing to compare with, which is never a pass
  Fail,              // an image, but not the right one
  ConstantImage,     // every pixel is the same, which the reference's are not
  InvalidPixels,     // NaN, infinite, or negative where the case does not allow it
  WrongChannels,     // R, G or B is missing
  WrongSize,         // another width or height
  Stale,             // the image is older than its render, or of another scene or render
  Unreadable,        // what should be the image cannot be read as one
  NoOutput,          // the renderer ended well but left no image
  Timeout,           // of the clock, or of processor time
  OutOfMemory,       // beyond its memory limit
  Crash,             // could not start, was killed by a signal, or ended with an exit code
};

inline constexpr std::array kVerdicts{
    Verdict::Pass,          Verdict::PassWithRemarks,  Verdict::Unsupported, Verdict::Skipped,
    Verdict::Inconclusive,  Verdict::MissingReference, Verdict::Fail,        Verdict::ConstantImage,
    Verdict::InvalidPixels, Verdict::WrongChannels,    Verdict::WrongSize,   Verdict::Stale,
    Verdict::Unreadable,    Verdict::NoOutput,         Verdict::Timeout,     Verdict::OutOfMemory,
    Verdict::Crash};

/// What is known after a verdict: of the renderer's image, or why there is none to speak of.
enum class VerdictKind { Pass, Unsupported, Skipped, Inconclusive, MissingReference, WrongImage, NoImage };

constexpr VerdictKind kind_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
    case Verdict::PassWithRemarks:
      return VerdictKind::Pass;
    case Verdict::Unsupported:
      return VerdictKind::Unsupported;
    case Verdict::Skipped:
      return VerdictKind::Skipped;
    case Verdict::Inconclusive:
      return VerdictKind::Inconclusive;
    case Verdict::MissingReference:
      return VerdictKind::MissingReference;
    case Verdict::Fail:
    case Verdict::ConstantImage:
    case Verdict::InvalidPixels:
    case Verdict::WrongChannels:
    case Verdict::WrongSize:
      return VerdictKind::WrongImage;
    case Verdict::Stale:
    case Verdict::Unreadable:
    case Verdict::NoOutput:
    case Verdict::Timeout:
    case Verdict::OutOfMemory:
    case Verdict::Crash:
      return VerdictKind::NoImage;
  }
  return VerdictKind::NoImage;
}

/// Whether every gate and check holds, with or without remarks.
constexpr bool passes(Verdict verdict) { return kind_of(verdict) == VerdictKind::Pass; }

/// "pass", "no output", ...
std::string_view verdict_name(Verdict verdict);

/// The verdict of that name, if there is one.
std::optional<Verdict> verdict_named(std::string_view name);

/// As fields() write and read it. InputError for an unknown name.
inline std::string_view to_text(Verdict value) { return verdict_name(value); }
void from_text(std::string_view name, Verdict& value);

Verdict worse(Verdict a, Verdict b);

/// Whether the verdict says of the renderer that it is right or not: all but skipped, inconclusive and
/// missing reference.
bool is_decided(Verdict verdict);

/// True for every verdict that makes a run end with status 1: all but passes and unsupported.
bool counts_as_failure(Verdict verdict);

/// Whether an entry of the configuration can expect the verdict. A run that ended early and a reference that
/// is missing say nothing of the renderer. Remarks can be known where a strict run is to accept them.
inline bool can_be_expected(Verdict verdict) {
  return verdict == Verdict::PassWithRemarks ||
         (counts_as_failure(verdict) && verdict != Verdict::Skipped && verdict != Verdict::MissingReference);
}

/// How a verdict compares with the failures that the configuration expects.
enum class Expectation {
  None,   // no failure is expected
  Known,  // it is the failure that is expected, which makes no run fail
  News,   // a failure is expected, but this is another one, a much worse one, or a pass; or the run is strict
          // and the pass has remarks
};

inline constexpr std::array kExpectations{Expectation::None, Expectation::Known, Expectation::News};

/// "none", "known", "news".
std::string_view expectation_name(Expectation expectation);
std::optional<Expectation> expectation_named(std::string_view name);
inline std::string_view to_text(Expectation value) { return expectation_name(value); }
void from_text(std::string_view name, Expectation& value);

/// What reports call a verdict with its expectation: "known", "unexpected pass", else the name of the
/// verdict.
std::string_view state_name(Verdict verdict, Expectation expectation);
inline constexpr std::string_view kKnown = "known";
inline constexpr std::string_view kUnexpectedPass = "unexpected pass";

/// As counts_as_failure(verdict), but a known failure does not count, and an unexpected pass does.
bool counts_as_failure(Verdict verdict, Expectation expectation);

/// Whether the first of two states is worse: in the order of the verdicts, with known failures after what is
/// unsupported and unexpected passes after what was skipped.
bool is_worse(Verdict verdict, Expectation expectation, Verdict than, Expectation than_expectation);

}  // namespace orbs::results
