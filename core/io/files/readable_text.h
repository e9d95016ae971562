#pragma once

#include <string>
#include <string_view>

namespace noonmark {

/// Normalises UTF-8 text for parsers of numbers and units: ASCII in lower case, full-width forms as ASCII,
/// typographic quotes and primes as ' and ", every kind of blank as a space, blanks at both ends removed. Any
/// other character, and every byte that is not UTF-8, becomes one '?'. Never throws except for lack of
/// memory; O(bytes).
std::string foldText(std::string_view utf8);

/// The encodings of tables that state none.
enum class TextEncoding {
    utf8,
    windows1252,  ///< and Latin-1, which it contains
    cp932,        ///< Shift JIS of Windows
    big5,         ///< traditional Chinese, CP950 of Windows
    gbk,          ///< simplified Chinese, CP936 of Windows
    cp949,        ///< Korean, EUC-KR and what Windows adds
};

/// What bytes of unknown encoding most likely are: UTF-8 where they can be; CP932 where two of its characters
/// of two bytes follow each other, as in Japanese words; Big5, GBK or CP949 likewise, by words of tables of
/// buildings or by where their common characters lie; else Windows-1252. A short Chinese or Korean name alone
/// can be misjudged: what most texts of a table are tells more (readableText()).
TextEncoding guessEncoding(std::string_view bytes);

/// The encoding for people: "Windows-1252 (Latin-1)".
std::string_view nameOf(TextEncoding encoding);

/// Text of unknown encoding (a Shapefile without .cpg) as UTF-8: as it stands where it is UTF-8 already, else
/// by `likely`, what the table most likely is in, or by guessEncoding() where that is UTF-8. O(bytes).
std::string readableText(std::string_view bytes, TextEncoding likely = TextEncoding::utf8);

/// The code point at `at` of UTF-8 text; advances `at` past it, or by one byte, returning U+FFFD, if the
/// bytes are not UTF-8.
char32_t nextCodePoint(std::string_view text, std::size_t& at);

void appendUtf8(std::string& text, char32_t point);

}  // namespace noonmark
