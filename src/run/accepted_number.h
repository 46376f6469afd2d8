#pragma once

#include "results/target_record.h"

#include <string>

namespace orbs::run {

/// How the number of a check compares with the one that was recorded when the failure was accepted.
enum class AcceptedChange { Within, Better, Worse, OtherSide };

/// The error of a number is how far it is from the right one: the mean squared error of a PSNR, the distance
/// from the middle of two limits, from 0 where there is only a largest value, from 1 where there is only a
/// least one, such as that of SSIM.
///
/// An error is worse or better than the accepted one where it differs by more than noise, by more than
/// `tolerance` of it and, but for a PSNR, by more than kLeastLight. Only the number was recorded, so the
/// accepted one is taken to have as wide an interval as that of today, and two such numbers differ by less
/// than sqrt(2) times half of it. The interval is the number's own; for a PSNR that of bias_squared in shares
/// of mse; for local_bias the error that noise hides over tiles of its size, smallest_error_16px, to both
/// sides. Other numbers have none.
///
/// OtherSide: between two limits, all of the interval lies on the side of the middle where the accepted
/// number does not. Too much light and too little are different failures.
AcceptedChange compare_with_accepted(double accepted,
                                     const results::Check& check,
                                     const results::TargetRecord& target,
                                     double tolerance);

/// The number of the check in the target, nullptr if there is none.
const results::Measure* measure_of(const results::TargetRecord& target, const std::string& name);

/// "R is 2.98 % darker", "the PSNR is 31.2 dB", "window_error_16px is +0.02": with the sign where the check
/// has two limits and no words of its own.
std::string number_said(double number, const results::Check& check);
/// The same without what it is of: "2.98 % darker".
std::string number_text(double number, const results::Check& check);

}  // namespace orbs::run
