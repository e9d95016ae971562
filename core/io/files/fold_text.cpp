#include "core/io/files/fold_text.h"

#include <cstddef>

#include "core/io/files/readable_text.h"

namespace noonmark {

namespace {

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
