#include "results/prices.h"

#include "json/object_reader.h"

namespace orbs::results {

namespace {

PriceRecord read_price(json::ObjectReader& in) {
  return {in.text("name"), in.object("time_ratio").number("median"), in.number("error_ratio"),
          in.text("target")};
}

}  // namespace

std::map<std::string, std::vector<PriceRecord>> read_prices(const std::filesystem::path& file) {
  std::map<std::string, std::vector<PriceRecord>> prices;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return prices;
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-prices/1"});
  for (auto& scene : in.objects("scenes"))
    for (auto& way : scene.objects("alternatives")) prices[scene.text("scene")].push_back(read_price(way));
  return prices;
}

}  // namespace orbs::results
