#include "core/mesh_reader/dxf_groups.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace noonmark {

namespace {

std::string trimmed(const std::string& line) {
    constexpr const char* blanks = " \t\r";
    const auto first = line.find_first_not_of(blanks);
    return first == line.npos ? std::string() : line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

template <class Number>
std::optional<Number> parse(const std::string& text) {
    Number number{};
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<double> parseDxfNumber(const std::string& text) {
    const auto number = parse<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string DxfEntity::text(int code) const {
    const auto found = std::ranges::find(groups, code, &std::pair<int, std::string>::first);
    return found == groups.end() ? std::string() : found->second;
}

double DxfEntity::number(int code, double otherwise) const {
    return parseDxfNumber(text(code)).value_or(otherwise);
}

int DxfEntity::whole(int code, int otherwise) const { return parse<int>(text(code)).value_or(otherwise); }

glm::dvec3 DxfEntity::point(int first) const {
    return {number(first), number(first + 10), number(first + 20)};
}

bool DxfEntity::has(int code) const {
    return std::ranges::find(groups, code, &std::pair<int, std::string>::first) != groups.end();
}

DxfReader::DxfReader(std::istream& stream) : stream_(stream) { good_ = readPair(); }

bool DxfReader::readPair() {
    std::string line;
    if (!std::getline(stream_, line)) return false;
    const auto code = parse<int>(trimmed(line));
    if (!code || !std::getline(stream_, line)) return false;
    code_ = *code;
    value_ = trimmed(line);
    return true;
}

std::optional<DxfEntity> DxfReader::next() {
    while (good_ && code_ != 0) good_ = readPair();  // comments (999) before the first entity
    if (!good_) return std::nullopt;
    DxfEntity entity{value_, {}};
    for (good_ = readPair(); good_ && code_ != 0; good_ = readPair())
        entity.groups.emplace_back(code_, value_);
    return entity;
}

}  // namespace noonmark
