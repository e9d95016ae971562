#include "core/io/files/readable_text.h"

#include <iconv.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

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

bool isBetween(char byte, unsigned low, unsigned high) {
    const auto value = static_cast<unsigned char>(byte);
    return value >= low && value <= high;
}

// Two characters of two bytes in a row, of which one begins with a byte that is no letter of Latin-1.
bool looksJapanese(std::string_view bytes) {
    std::size_t inRow = 0;
    bool hasKana = false;
    for (std::size_t i = 0; i < bytes.size();) {
        const bool isLead = isBetween(bytes[i], 0x81, 0x9F) || isBetween(bytes[i], 0xE0, 0xFC);
        const bool isPair = isLead && i + 1 < bytes.size() &&
                            (isBetween(bytes[i + 1], 0x40, 0x7E) || isBetween(bytes[i + 1], 0x80, 0xFC));
        inRow = isPair ? inRow + 1 : 0;
        hasKana = (inRow > 1 && hasKana) || (isPair && isBetween(bytes[i], 0x81, 0x9F));
        if (inRow > 1 && hasKana) return true;
        i += isPair ? 2 : 1;
    }
    return false;
}

/// An encoding of tables that state none.
struct EncodingEntry {
    TextEncoding encoding;
    std::string_view name;             // for people
    const char* converter = nullptr;   // iconv's name; nothing: read here
    std::u32string_view characters{};  // that names of fields of buildings are made of
};

constexpr std::array encodings{
    EncodingEntry{TextEncoding::utf8, "UTF-8"},
    EncodingEntry{TextEncoding::windows1252, "Windows-1252 (Latin-1)"},
    EncodingEntry{TextEncoding::cp932, "CP932 (Shift JIS)", "CP932"},
    EncodingEntry{TextEncoding::big5, "Big5 (CP950)", "CP950", U"高層樓棟號數建築物面積屋頂地上下名稱"},
    EncodingEntry{TextEncoding::gbk, "GBK (CP936)", "GBK", U"高层楼栋号数建筑物面积屋顶地上下名称"},
    EncodingEntry{TextEncoding::cp949, "CP949 (EUC-KR)", "CP949", U"높이층수건물면적지붕상하동명"},
};

const EncodingEntry& entryOf(TextEncoding encoding) {
    return *std::ranges::find(encodings, encoding, &EncodingEntry::encoding);
}

// Nothing where the bytes are not of that encoding, or the system does not know it.
std::optional<std::string> converted(std::string_view bytes, TextEncoding encoding) {
    const iconv_t converter = ::iconv_open("UTF-8", entryOf(encoding).converter);
    if (converter == iconv_t(-1)) return std::nullopt;
    std::string source(bytes), text(bytes.size() * 3, '\0');
    char *from = source.data(), *into = text.data();
    std::size_t left = source.size(), room = text.size();
    const bool isGood = ::iconv(converter, &from, &left, &into, &room) != std::size_t(-1) && left == 0;
    ::iconv_close(converter);
    text.resize(text.size() - room);
    return isGood ? std::optional(std::move(text)) : std::nullopt;
}

// The bytes of the characters of two bytes, as Big5, GBK and CP949 have them. Nothing where another byte
// above ASCII stands between them, or where the text could be one of Latin-1: no two of them in a row, or
// none whose bytes are both beyond ASCII with one that is no letter there.
std::vector<std::pair<unsigned, unsigned>> eastAsianPairs(std::string_view bytes) {
    std::vector<std::pair<unsigned, unsigned>> pairs;
    std::size_t inRow = 0;
    bool areInRow = false, isNoLatin = false;
    for (std::size_t i = 0; i < bytes.size();) {
        if (isBetween(bytes[i], 0, 0x7F)) {
            inRow = 0, ++i;
            continue;
        }
        const bool isPair = isBetween(bytes[i], 0xA1, 0xF9) && i + 1 < bytes.size() &&
                            (isBetween(bytes[i + 1], 0x40, 0x7E) || isBetween(bytes[i + 1], 0xA1, 0xFE));
        if (!isPair) return {};
        areInRow = areInRow || ++inRow > 1;
        isNoLatin = isNoLatin || (!isBetween(bytes[i + 1], 0, 0x7F) &&
                                  (isBetween(bytes[i], 0xA1, 0xBF) || isBetween(bytes[i + 1], 0xA1, 0xBF)));
        pairs.emplace_back(static_cast<unsigned char>(bytes[i]), static_cast<unsigned char>(bytes[i + 1]));
        i += 2;
    }
    return areInRow && isNoLatin ? pairs : std::vector<std::pair<unsigned, unsigned>>();
}

// Where a font's common characters are: GBK's and CP949's have no second byte of ASCII, all of Korean's
// syllables begin between 0xB0 and 0xC8, Big5's common ones between 0xA4 and 0xC6, and nothing of Chinese
// does below 0xB0 in GBK.
TextEncoding guessByBytes(const std::vector<std::pair<unsigned, unsigned>>& pairs) {
    const auto any = [&](auto is) { return std::ranges::any_of(pairs, is); };
    if (any([](const auto& pair) { return pair.second < 0xA1 || (pair.first > 0xA3 && pair.first < 0xB0); }))
        return TextEncoding::big5;
    return any([](const auto& pair) { return pair.first > 0xC8; }) ? TextEncoding::gbk : TextEncoding::cp949;
}

std::size_t countKnown(std::string_view utf8, std::u32string_view known) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < utf8.size();)
        count += known.find(nextCodePoint(utf8, at)) != known.npos ? 1U : 0U;
    return count;
}

// Words of tables of buildings tell more than the bytes do.
std::optional<TextEncoding> guessEastAsian(std::string_view bytes) {
    const auto pairs = eastAsianPairs(bytes);
    if (pairs.empty()) return std::nullopt;
    std::size_t maxKnown = 0;
    TextEncoding likeliest = guessByBytes(pairs);
    for (const EncodingEntry& entry : encodings) {
        if (entry.characters.empty()) continue;
        const auto text = converted(bytes, entry.encoding);
        const std::size_t known = text ? countKnown(*text, entry.characters) : 0;
        if (known > maxKnown) maxKnown = known, likeliest = entry.encoding;
    }
    return converted(bytes, likeliest) ? std::optional(likeliest) : std::nullopt;
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
    constexpr char32_t minimum[] = {0, 0x80, 0x800, 0x10000};  // a form longer than necessary is not UTF-8
    if (point < minimum[more]) return notText;
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

TextEncoding guessEncoding(std::string_view bytes) {
    if (isUtf8(bytes)) return TextEncoding::utf8;
    if (looksJapanese(bytes) && converted(bytes, TextEncoding::cp932)) return TextEncoding::cp932;
    return guessEastAsian(bytes).value_or(TextEncoding::windows1252);
}

std::string_view nameOf(TextEncoding encoding) { return entryOf(encoding).name; }

std::string readableText(std::string_view bytes, TextEncoding likely) {
    if (isUtf8(bytes)) return std::string(bytes);
    if (likely == TextEncoding::utf8) likely = guessEncoding(bytes);
    if (entryOf(likely).converter != nullptr)
        if (auto text = converted(bytes, likely)) return *std::move(text);
    std::string text;
    for (const char byte : bytes) appendUtf8(text, pointOfWindows1252(static_cast<unsigned char>(byte)));
    return text;
}

}  // namespace noonmark
