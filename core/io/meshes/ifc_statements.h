#pragma once

#include <cstddef>
#include <streambuf>
#include <string>
#include <string_view>
#include <vector>

namespace noonmark {

/// Takes the next statement of an IFC text file up to its semicolon, which texts may contain too; of one
/// longer than `longest` bytes its beginning. False at the end of the file.
bool takeIfcStatement(std::streambuf& bytes, std::string& statement, std::size_t longest);

/// The arguments of "IFCSITE('a',#12,(49,6),$)": texts may contain commas and parentheses. One empty word
/// for none.
std::vector<std::string> ifcArguments(std::string_view statement);

/// Without blanks and ends of lines outside of texts.
std::string withoutIfcBlanks(std::string_view statement);

}  // namespace noonmark
