#include "core/io/meshes/ifc_site.h"
#include "core/io/settings/read_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <string_view>
#include <vector>

namespace noonmark {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t maxDirections = 100'000;
constexpr std::size_t longestStatement = 4096;  // of those that matter; the rest of a longer one is skipped

std::string withoutBlanks(std::string_view text) {
    std::string plain;
    for (const char c : text)
        if (c != ' ' && c != '\t' && c != '\r' && c != '\n') plain += c;
    return plain;
}

// The arguments of "IFCSITE('a',#12,(49,6),$)": texts may contain commas and parentheses.
Words argumentsOf(std::string_view statement) {
    Words words{""};
    int depth = 0;
    bool quoted = false;
    for (const char c : statement.substr(std::min(statement.find('('), statement.size()))) {
        if (c == '\'') quoted = !quoted;
        if (!quoted && c == '(' && ++depth == 1) continue;
        if (!quoted && c == ')' && --depth == 0) break;
        if (!quoted && c == ',' && depth == 1)
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

std::optional<double> numberOf(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool good = error == std::errc() && end != text.data() && std::isfinite(number);
    return good ? std::optional(number) : std::nullopt;
}

std::vector<double> numbersOf(const std::string& list) {
    std::vector<double> numbers;
    for (const std::string& word : argumentsOf(list))
        if (const auto number = numberOf(word)) numbers.push_back(*number);
    return numbers;
}

// (degrees, minutes, seconds, millionths of a second), all of one sign.
std::optional<double> degreesOf(const std::string& list) {
    const std::vector<double> parts = numbersOf(list);
    if (parts.size() < 3) return std::nullopt;
    const double seconds = parts[2] + (parts.size() > 3 ? parts[3] / 1e6 : 0);
    return parts[0] + parts[1] / 60 + seconds / 3600;
}

// The next statement up to its semicolon, which texts may contain too. Of a longer one, its beginning. False
// at the end of the file.
bool takeStatement(std::streambuf& bytes, std::string& statement) {
    statement.clear();
    bool quoted = false;
    using Traits = std::streambuf::traits_type;
    for (auto c = bytes.sbumpc(); !Traits::eq_int_type(c, Traits::eof()); c = bytes.sbumpc()) {
        const char letter = Traits::to_char_type(c);
        if (letter == '\'') quoted = !quoted;
        if (letter == ';' && !quoted) return true;
        if (statement.size() < longestStatement) statement += letter;
    }
    return false;
}

// Collects the statements that matter, which may come in any order.
class SiteReader {
public:
    void take(std::string_view statement) {
        const std::string plain = withoutBlanks(statement);
        const auto equals = plain.find('=');
        if (equals == plain.npos) return;
        const std::string id = plain.substr(0, equals), body = plain.substr(equals + 1);
        const Words words = argumentsOf(body);
        if (body.starts_with("IFCSITE(")) takeSite(words);
        if (body.starts_with("IFCDIRECTION(") && directions_.size() < maxDirections)
            directions_.emplace(id, words.front());
        if (body.starts_with("IFCGEOMETRICREPRESENTATIONCONTEXT(") && words.size() > 5 && north_.empty())
            north_ = words[5].starts_with('#') ? words[5] : "";
        if (body.starts_with("IFCPROJECTEDCRS(")) crs_ = words.front();
        if (body.starts_with("IFCMAPCONVERSION(") && words.size() > 3) origin_ = words[2] + ", " + words[3];
    }

    IfcSite site() {
        if (const auto north = directions_.find(north_); north != directions_.end()) {
            const std::vector<double> axes = numbersOf(north->second);
            const double degrees =
                axes.size() < 2 ? 0 : std::atan2(axes[0], axes[1]) * 180 / std::numbers::pi;
            if (std::abs(degrees) > 0.01) site_.trueNorthDeg = degrees;
        }
        std::erase(crs_, '\'');
        if (!origin_.empty()) site_.mapConversion = crs_.empty() ? origin_ : crs_ + " " + origin_;
        return site_;
    }

private:
    void takeSite(const Words& words) {
        if (words.size() < 12) return;
        const auto latitude = degreesOf(words[9]), longitude = degreesOf(words[10]);
        if (latitude && longitude) site_.place = LonLat{*longitude, *latitude};
        site_.elevationM = numberOf(words[11]);
    }

    IfcSite site_;
    std::map<std::string, std::string> directions_;
    std::string north_, crs_, origin_;
};

}  // namespace

IfcSite readIfcSite(const std::filesystem::path& file, const std::stop_token& stop) {
    std::filebuf bytes;
    SiteReader reader;
    if (bytes.open(file, std::ios::in | std::ios::binary) == nullptr) return reader.site();
    for (std::string statement; takeStatement(bytes, statement) && !stop.stop_requested();)
        reader.take(statement);
    return reader.site();
}

std::string describe(const IfcSite& site) {
    Words words;
    if (site.place)
        words.push_back(fmt::format("its place ({} {:.6f},{:.6f})", readOption("mesh_anchor"),
                                    site.place->lonDeg, site.place->latDeg));
    if (site.place && site.elevationM && *site.elevationM != 0)
        words.push_back(fmt::format("its elevation, {:g}", *site.elevationM));
    if (site.trueNorthDeg)
        words.push_back(fmt::format("true north {:.4g} deg clockwise of its y axis ({} {:.4g})",
                                    *site.trueNorthDeg, readOption("mesh_north_deg"), -*site.trueNorthDeg));
    if (!site.mapConversion.empty()) words.push_back("its place on a map, " + site.mapConversion);
    return fmt::format("{}", fmt::join(words, "; "));
}

}  // namespace noonmark
