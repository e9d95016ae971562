#include "core/io/files/fold_text.h"

#include <cstddef>
#include <cstdint>

namespace noonmark {

namespace {

constexpr char32_t notText = 0xFFFD;  // the replacement character

int continuationBytes(unsigned char lead) {
    if (lead >= 0xC2 && lead < 0xE0) return 1;
    if (lead >= 0xE0 && lead < 0xF0) return 2;
    if (lead >= 0xF0 && lead < 0xF5) return 3;
    return 0;
}

// The code point at `at`; advances `at` past it, or by one byte if the bytes are not UTF-8.
char32_t nextCodePoint(std::string_view text, std::size_t& at) {
    const auto lead = static_cast<unsigned char>(text[at++]);
    if (lead < 0x80) return lead;
    const auto more = std::size_t(continuationBytes(lead));
    if (more == 0 || text.size() - at < more) return notText;
    char32_t point = lead & (0x3FU >> more);
    for (std::size_t i = 0; i < more; ++i) {
        const auto byte = static_cast<unsigned char>(text[at + i]);
        if ((byte & 0xC0U) != 0x80U) return notText;
        point = (point << 6U) | (byte & 0x3FU);
    }
    constexpr char32_t least[] = {0, 0x80, 0x800, 0x10000};  // a form longer than necessary is not UTF-8
    if (point < least[more]) return notText;
    at += more;
    return point;
}

bool isBlank(char32_t point) {
    const bool wide = point >= 0x2000 && point <= 0x200B;
    return (point >= 9 && point <= 13) || point == ' ' || point == 0xA0 || wide || point == 0x202F ||
           point == 0x3000;
}

// The ASCII equivalent of a mark; 0 if there is none.
char asciiMark(char32_t point) {
    switch (point) {
        case 0x2018:
        case 0x2019:
        case 0x201B:
        case 0x2032:
        case 0xB4:
        case '`':
            return '\'';
        case 0x201C:
        case 0x201D:
        case 0x201F:
        case 0x2033:
            return '"';
        case 0x2212:
        case 0x2010:
        case 0x2011:
            return '-';
        case 0x43C:
        case 0x41C:
            return 'm';  // Cyrillic em, the symbol of the metre in Cyrillic script
        default:
            return 0;
    }
}

char folded(char32_t point) {
    if (point >= 0xFF01 && point <= 0xFF5E) point -= 0xFEE0;  // full-width forms
    if (isBlank(point)) return ' ';
    if (const char mark = asciiMark(point)) return mark;
    if (point < 0x20 || point >= 0x7F) return '?';
    const bool upper = point >= 'A' && point <= 'Z';
    return char(upper ? point - 'A' + 'a' : point);
}

}  // namespace

std::string foldText(std::string_view utf8) {
    std::string text;
    for (std::size_t at = 0; at < utf8.size();) text += folded(nextCodePoint(utf8, at));
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace noonmark
