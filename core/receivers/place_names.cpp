#include "core/receivers/place_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/sun/close_names.h"

namespace noonmark {

namespace {

constexpr std::size_t mostLetters = 120;

// Bytes of the UTF-8 character at the front of the text; 0 where there is none.
std::size_t characterBytes(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t bytes = lead < 0x80 ? 1 : lead < 0xC2 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (bytes == 0 || lead > 0xF4 || text.size() < bytes) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 0;
    if (bytes < 3) return bytes;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool tooLong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool noCharacter = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
    return tooLong || noCharacter ? 0 : bytes;
}

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

std::string lowered(std::string_view text) {
    std::string low(text);
    for (char& c : low)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return low;
}

std::vector<std::string> namesLike(const std::vector<Place>& places, std::string_view text) {
    constexpr std::size_t most = 5;
    std::vector<std::string> names;
    for (const Place& place : places) names.push_back(place.name);
    std::vector<std::string> close = findCloseNames(text, names, most);
    const std::string wanted = lowered(text);
    for (const std::string& name : names)
        if (close.size() < most && !wanted.empty() && lowered(name).find(wanted) != std::string::npos &&
            std::ranges::find(close, name) == close.end())
            close.push_back(name);
    return close;
}

}  // namespace

std::string cleanName(std::string_view text) {
    std::string name;
    for (std::size_t letters = 0; !text.empty() && letters < mostLetters; ++letters) {
        const std::size_t bytes = characterBytes(text);
        if (bytes == 0)
            name += '?';
        else if (isControl(text.front()))
            name += ' ';
        else
            name += text.substr(0, bytes);
        text.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    const auto first = name.find_first_not_of(' ');
    if (first == name.npos) return {};
    return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

void nameApart(std::vector<Place>& places) {
    std::set<std::string> used;
    for (const Place& place : places) used.insert(place.name);
    std::set<std::string> given;
    for (Place& place : places) {
        if (place.name.empty()) place.name = fmt::format("{} ({})", nameOf(place.kind), place.source);
        const std::string name = place.name;
        for (int number = 2; given.contains(place.name); ++number) {
            const std::string numbered = fmt::format("{} ({})", name, number);
            if (!used.contains(numbered)) place.name = numbered;
        }
        given.insert(place.name);
        used.insert(place.name);
    }
}

Result<Place> findPlace(const std::vector<Place>& places, std::string_view name) {
    if (const auto exact = std::ranges::find(places, name, &Place::name); exact != places.end())
        return *exact;
    const std::string wanted = lowered(name);
    for (const Place& place : places)
        if (lowered(place.name) == wanted) return place;
    const std::vector<std::string> close = namesLike(places, name);
    if (close.empty())
        return failure("There is no place of this name", fmt::format("place '{}'", name),
                       "List the places: noonmark-cli places");
    return failure("There is no place of this name", fmt::format("place '{}'", name),
                   fmt::format("Did you mean {}?", fmt::join(close, ", ")));
}

Region regionOf(const Place& place) { return {place.name, place.polygons}; }

double area(const Place& place) {
    double sum = 0;
    for (const Footprint& polygon : place.polygons) sum += area(polygon);
    return sum;
}

Box2 bounds(const Place& place) {
    Box2 box;
    for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    return box;
}

bool hasOwnName(const Place& place) {
    return !place.name.starts_with(std::string(nameOf(place.kind)) + " (" + place.source);
}

}  // namespace noonmark
