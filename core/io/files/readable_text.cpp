#include "core/io/files/readable_text.h"

#include <array>
#include <cstddef>

namespace noonmark {

namespace {

constexpr char32_t notText = 0xFFFD;  // the replacement character

int continuationBytes(unsigned char lead) {
    if (lead >= 0xC2 && lead < 0xE0) return 1;
    if (lead >= 0xE0 && lead < 0xF0) return 2;
    if (lead >= 0xF0 && lead < 0xF5) return 3;
    return 0;
}

// Windows-1252 between 0x80 and 0x9F; elsewhere it is equal to Latin-1. 0: not used.
constexpr std::array<char16_t, 32> windows1252{
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

char32_t pointOfWindows1252(unsigned char byte) {
    if (byte < 0x80 || byte >= 0xA0) return byte;
    const char16_t point = windows1252[byte - 0x80U];
    return point != 0 ? point : notText;
}

bool isUtf8(std::string_view bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t before = at;
        if (nextCodePoint(bytes, at) == notText && at == before + 1) return false;
    }
    return true;
}

}  // namespace

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

void appendUtf8(std::string& text, char32_t point) {
    const auto more = [&](int shift) { text += char(0x80U | ((point >> shift) & 0x3FU)); };
    if (point < 0x80) {
        text += char(point);
    } else if (point < 0x800) {
        text += char(0xC0U | (point >> 6U));
        more(0);
    } else if (point < 0x10000) {
        text += char(0xE0U | (point >> 12U));
        more(6), more(0);
    } else {
        text += char(0xF0U | (point >> 18U));
        more(12), more(6), more(0);
    }
}

std::string readableText(std::string_view bytes) {
    if (isUtf8(bytes)) return std::string(bytes);
    std::string text;
    for (const char byte : bytes) appendUtf8(text, pointOfWindows1252(static_cast<unsigned char>(byte)));
    return text;
}

}  // namespace noonmark
