#include "scene/lights/ies.h"

#include "base/error.h"
#include "base/nth.h"
#include "base/text.h"
#include "scene/text_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// After the TILT line an LM-63 file is one stream of numbers; line ends carry no meaning.
class NumberStream {
 public:
  NumberStream(const std::string& name, std::string_view rest) : name_(name), rest_(rest) {}

  double next(const char* what) {
    constexpr std::string_view kSeparators = " \t\r\n,";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSeparators), rest_.size()));
    if (rest_.empty()) fail(fmt::format("the file ends where {} should stand", what));
    const auto token = rest_.substr(0, rest_.find_first_of(kSeparators));
    rest_.remove_prefix(token.size());
    const auto number = to_number(token);
    if (!number || !std::isfinite(*number)) fail(fmt::format("{} must be a number, is '{}'", what, token));
    return *number;
  }

  int count(const char* what, int max) {
    const double number = next(what);
    if (number < 1 || number > max || number != std::floor(number))
      fail(fmt::format("{} must be a whole number in [1, {}], is {}", what, max, number));
    return static_cast<int>(number);
  }

  std::vector<double> list(int length, const char* what) {
    // A number takes at least two bytes with its separator: a count beyond that must not allocate memory.
    if (static_cast<std::size_t>(length) > (rest_.size() + 1) / 2)
      fail(fmt::format("the file ends before its {} numbers called {}", length, what));
    std::vector<double> numbers(static_cast<std::size_t>(length));
    for (double& number : numbers) number = next(what);
    return numbers;
  }

  std::vector<double> angles(int length, const char* what) {
    auto numbers = list(length, what);
    for (std::size_t i = 1; i < numbers.size(); ++i)
      if (!(numbers[i] > numbers[i - 1]))
        fail(fmt::format("{} must ascend, found {} after {}", what, numbers[i], numbers[i - 1]));
    return numbers;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: not a usable LM-63 file: {}", name_, problem));
  }

 private:
  const std::string& name_;
  std::string_view rest_;
};

struct Header {
  bool old_ballast_factor = false;  // 1986 and 1991: the second factor of the ballast line multiplies
  std::string tilt;                 // in capitals, unless it names a file
  std::string_view rest;
};

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return capitals;
}

// What a line says of the tilt, if it does: "TILT=NONE", which programs write in small letters and with
// blanks, too.
std::optional<std::string_view> tilt_of(std::string_view line) {
  constexpr std::string_view kKey = "TILT";
  if (in_capitals(line.substr(0, kKey.size())) != kKey) return std::nullopt;
  const auto rest = trim(line.substr(kKey.size()));
  if (!rest.starts_with('=')) return std::nullopt;
  return trim(rest.substr(1));
}

// Editors of Windows call it "Unicode". A zero byte is in no text of ASCII.
bool is_utf16(std::string_view text) {
  constexpr std::size_t kEnough = 64;
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
         text.substr(0, kEnough).find('\0') != std::string_view::npos;
}

// adapters/cycles_ies.py has the same rules.
Header read_header(const std::string& name, std::string_view text) {
  take_byte_order_mark(text);
  if (is_utf16(text))
    throw InputError(fmt::format(
        "{}: not a usable LM-63 file: its text is in UTF-16; save it in ASCII or UTF-8, as 'iconv -f UTF-16 -t "
        "UTF-8' does",
        name));
  Header header;
  for (bool is_first = true; !text.empty(); is_first = false) {
    const auto line = trim(take_line(text));
    if (is_first) {
      const auto version = in_capitals(line.substr(0, 16));
      header.old_ballast_factor = !version.starts_with("IESNA:LM-63") && !version.starts_with("IES:LM-63");
    }
    const auto tilt = tilt_of(line);
    if (!tilt) continue;
    const auto capitals = in_capitals(*tilt);
    const bool is_word = capitals == "NONE" || capitals == "INCLUDE";
    header.tilt = is_word ? capitals : std::string(*tilt);
    header.rest = text;
    return header;
  }
  throw InputError(fmt::format("{}: not a usable LM-63 file: there is no line that starts with TILT=", name));
}

double read_tilt_factor(NumberStream& in, const std::string& tilt) {
  if (tilt == "NONE") return 1;
  if (tilt != "INCLUDE") in.fail(fmt::format("TILT={}: only NONE and INCLUDE are supported", tilt));
  in.count("lamp geometry", 3);
  const int pairs = in.count("number of tilt angles", 10000);
  const auto angles = in.list(pairs, "tilt angle");
  const auto factors = in.list(pairs, "tilt factor");
  const auto level = std::find(angles.begin(), angles.end(), 0.0);  // the light hangs level
  return level == angles.end() ? 1 : nth(factors, level - angles.begin());
}

// The azimuths at which a stored plane appears, by the symmetry that the range of planes implies (LM-63
// 5.12).
std::vector<double> azimuths_of(double plane, double first, double last) {
  if (last == 0) return {0, 360};
  if (first == 90 && last == 270) {
    if (plane == 180) return {180, 0, 360};
    return {plane, plane < 180 ? 180 - plane : 540 - plane};
  }
  if (last == 90) return {plane, 180 - plane, 180 + plane, 360 - plane};
  if (last == 180) return {plane, 360 - plane};
  return {plane};
}

// LM-63-2002 has the ranges whose symmetry azimuths_of() knows. LM-63-1995 had all that end above 180,
// without symmetry: such planes go around the circle if what is left of it is no wider than the steps before.
bool is_known_range(const std::vector<double>& planes) {
  const double first = planes.front();
  const double last = planes.back();
  if (first == 90) return last == 270;
  if (first != 0 || last > 360) return false;
  if (last == 0 || last == 90 || last == 180) return true;
  double widest_step = 0;
  for (std::size_t i = 1; i < planes.size(); ++i)
    widest_step = std::max(widest_step, planes[i] - planes[i - 1]);
  constexpr double kRounding_deg = 1e-6;  // of steps like 7.2
  return last > 180 && 360 - last <= widest_step + kRounding_deg;
}

double interpolate(const std::vector<double>& at, double x, std::size_t& low) {
  const auto above = std::upper_bound(at.begin(), at.end(), x);
  low = above == at.begin() ? 0 : static_cast<std::size_t>(above - at.begin()) - 1;
  if (low + 1 >= at.size()) return 0;
  return (x - at[low]) / (at[low + 1] - at[low]);
}

// Interpolates between the neighbours of 0 = 360, for a profile from 90 to 270 that has no plane at 180.
std::vector<double> plane_at_zero(const IesProfile& profile, std::ptrdiff_t rows) {
  const double to_first = profile.horizontal_deg.front();
  const double from_last = 360 - profile.horizontal_deg.back();
  const double share_of_first = from_last / (from_last + to_first);
  std::vector<double> between(profile.candela.begin(), profile.candela.begin() + rows);
  auto last = profile.candela.end() - rows;
  for (double& value : between) value = share_of_first * value + (1 - share_of_first) * *last++;
  return between;
}

// Planes for the whole circle. A file whose planes end below 360 (at 345, say) continues with its first
// plane.
IesProfile unfolded(const std::vector<double>& planes,
                    std::vector<double> vertical,
                    const std::vector<double>& candela) {
  std::map<double, std::size_t> plane_at;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (const double azimuth : azimuths_of(planes[i], planes.front(), planes.back()))
      plane_at.emplace(azimuth, i);
  const bool has_zero = plane_at.contains(0);
  if (has_zero) plane_at.emplace(360, plane_at.at(0));
  IesProfile profile;
  const auto rows = static_cast<std::ptrdiff_t>(vertical.size());
  for (const auto& [azimuth, plane] : plane_at) {
    profile.horizontal_deg.push_back(azimuth);
    const auto begin = candela.begin() + static_cast<std::ptrdiff_t>(plane) * rows;
    profile.candela.insert(profile.candela.end(), begin, begin + rows);
  }
  if (!has_zero) {
    const auto zero = plane_at_zero(profile, rows);
    profile.candela.insert(profile.candela.begin(), zero.begin(), zero.end());
    profile.candela.insert(profile.candela.end(), zero.begin(), zero.end());
    profile.horizontal_deg.insert(profile.horizontal_deg.begin(), 0);
    profile.horizontal_deg.push_back(360);
  }
  profile.vertical_deg = std::move(vertical);
  return profile;
}

}  // namespace

IesProfile parse_ies(const std::string& name, std::string_view text) {
  const Header header = read_header(name, text);
  NumberStream in(name, header.rest);
  const double tilt = read_tilt_factor(in, header.tilt);
  in.count("number of lamps", 1000000);
  in.next("lumens per lamp");
  const double multiplier = in.next("candela multiplier");
  const int n_vertical = in.count("number of vertical angles", 10000);
  const int n_horizontal = in.count("number of horizontal angles", 10000);
  if (in.count("photometric type", 3) != 1) in.fail("only type C photometry is supported");
  for (const char* what : {"units", "width", "length", "height"}) in.next(what);
  const double ballast = in.next("ballast factor");
  const double ballast_lamp = in.next("ballast-lamp factor");
  in.next("input watts");
  auto vertical = in.angles(n_vertical, "vertical angle");
  const auto horizontal = in.angles(n_horizontal, "horizontal angle");
  if (vertical.front() < 0 || vertical.back() > 180) in.fail("vertical angles of type C lie in [0, 180]");
  if (!is_known_range(horizontal))
    in.fail(fmt::format(
        "horizontal angles of type C run from 0 to 0, 90, 180 or 360, or from 90 to 270, and these from {} to "
        "{}; others say nothing of the rest of the circle",
        horizontal.front(), horizontal.back()));
  auto candela = in.list(n_vertical * n_horizontal, "candela value");
  const double factor = multiplier * ballast * tilt * (header.old_ballast_factor ? ballast_lamp : 1.0);
  for (double& value : candela) value *= factor;
  const double peak = *std::max_element(candela.begin(), candela.end());
  if (!(peak > 0) || *std::min_element(candela.begin(), candela.end()) < 0)
    in.fail("candela values must not be negative, and one must be above 0");
  if (!std::isfinite(peak)) in.fail("candela values times their factors are beyond what a number can hold");
  IesProfile profile = unfolded(horizontal, std::move(vertical), candela);
  profile.max_candela = peak;
  return profile;
}

double candela_at(const IesProfile& profile, double vertical_deg, double horizontal_deg) {
  const auto& vertical = profile.vertical_deg;
  if (vertical_deg < vertical.front() || vertical_deg > vertical.back()) return 0;
  const double phi = horizontal_deg - 360 * std::floor(horizontal_deg / 360);
  std::size_t v = 0;
  std::size_t h = 0;
  const double tv = interpolate(vertical, vertical_deg, v);
  const double th = interpolate(profile.horizontal_deg, phi, h);
  const auto value = [&](std::size_t plane, std::size_t row) {
    return profile.candela[plane * vertical.size() + row];
  };
  const std::size_t v1 = std::min(v + 1, vertical.size() - 1);
  const std::size_t h1 = std::min(h + 1, profile.horizontal_deg.size() - 1);
  return (1 - th) * ((1 - tv) * value(h, v) + tv * value(h, v1)) +
         th * ((1 - tv) * value(h1, v) + tv * value(h1, v1));
}

double candela_towards(const IesProfile& profile, Vec3d local_direction) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const auto& [x, y, z] = local_direction;
  return candela_at(profile, std::atan2(std::hypot(x, z), -y) * kDegrees, std::atan2(z, x) * kDegrees);
}

}  // namespace orbs::scene
