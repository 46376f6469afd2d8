#include "metrics/image_pair.h"

#include "base/parallel.h"
#include "image/colour.h"
#include "metrics/rare_light.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace orbs::metrics {

namespace {

struct DisplayForm {
  std::vector<float> samples;
  std::vector<double> luma;
};

DisplayForm display_form(const std::vector<float>& linear) {
  DisplayForm form;
  form.samples.resize(linear.size());
  std::transform(linear.begin(), linear.end(), form.samples.begin(),
                 [](float value) { return image::srgb_encode(std::clamp(value, 0.0F, 1.0F)); });
  form.luma.resize(linear.size() / 3);
  for (std::size_t pixel = 0; pixel < form.luma.size(); ++pixel) {
    const float* rgb = &form.samples[3 * pixel];
    form.luma[pixel] = image::luminance(rgb[0], rgb[1], rgb[2]);
  }
  return form;
}

}  // namespace

ImagePair make_image_pair(const image::Image& result,
                          const image::Image& reference,
                          const Mask& mask,
                          const PairSettings& settings) {
  ImagePair pair;
  static_cast<PairSamples&>(pair) = pair_samples(result, reference, mask, settings.result_noise);
  pair.threads = settings.threads;
  pair.looks = settings.looks;
  pair.spp = settings.spp;
  count_samples(pair, settings.sample_ratio);
  pair.common_noise = common_noise_of(settings.apart);
  pair.unseen_share = unseen_share(pair, settings.spp);
  if (settings.halves != nullptr) pair.area_noise = area_noise(pair, *settings.halves);
  if (settings.halves != nullptr)
    for (std::size_t half = 0; half < 2; ++half)
      pair.half_display.at(half) =
          display_form(image::select_rgb(settings.halves->at(half), "").pixels).samples;
  for_each_index(3, settings.threads, [&](int task) {
    if (task == 2) {
      pair.noise = test_noise(pair);
      return;
    }
    DisplayForm form = display_form(task == 0 ? pair.result : pair.reference);
    (task == 0 ? pair.result_display : pair.reference_display) = std::move(form.samples);
    (task == 0 ? pair.result_luma : pair.reference_luma) = std::move(form.luma);
  });
  return pair;
}

}  // namespace orbs::metrics
