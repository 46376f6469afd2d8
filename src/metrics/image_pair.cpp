#include "metrics/image_pair.h"

#include "base/parallel.h"
#include "image/colour.h"

#include <algorithm>
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
                          int threads) {
  ImagePair pair;
  pair.width = result.width;
  pair.height = result.height;
  pair.threads = threads;
  pair.included = included_pixels(mask, result.width, result.height);
  pair.included_count = static_cast<std::size_t>(std::count(pair.included.begin(), pair.included.end(), 1));
  pair.result = image::select_rgb(result, "").pixels;
  pair.reference = image::select_rgb(reference, "").pixels;
  for_each_index(2, threads, [&](int which) {
    DisplayForm form = display_form(which == 0 ? pair.result : pair.reference);
    (which == 0 ? pair.result_display : pair.reference_display) = std::move(form.samples);
    (which == 0 ? pair.result_luma : pair.reference_luma) = std::move(form.luma);
  });
  return pair;
}

}  // namespace orbs::metrics
