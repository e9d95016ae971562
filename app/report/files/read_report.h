#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace noonmark {

/// A filed report: its record, and what its pages print.
struct FiledReport {
    std::string recordName;  ///< "study.json"
    std::string record;
    std::string printed;    ///< the words of all pages, UTF-8; empty if the file is a record, not a PDF
    bool isBook = false;    ///< a book of sheets, with bookmarks
    bool isRecord = false;  ///< the record itself, without pages
};

/// Reads a PDF with its attached record, which has one of these names, or a record itself. The file comes
/// from a stranger: links, scripts and forms in it are not followed. Error: it cannot be read, is larger than
/// 256 MiB, or has no record (reports of versions before 0.2 have none; their study.json does). Backend:
/// read_report_poppler.cpp.
Result<FiledReport> readReport(const std::filesystem::path& file,
                               const std::vector<std::string_view>& recordNames);

/// The printed words of a PDF alone.
Result<std::string> readPrintedWords(const std::filesystem::path& file);

/// How the pages of two PDFs look.
struct PageComparison {
    std::size_t pages = 0;         ///< that were compared
    std::vector<int> different{};  ///< numbers of pages of which a part looks different, from 1
    std::vector<int> onlyInOne{};  ///< of pages that one of the two lacks, or of another size
};

/// Draws the pages of both PDFs as a viewer does, with all that covers them, and compares the pictures. Stops
/// soon after a stop request. Error: as of readReport(), or cancelled().
Result<PageComparison> comparePages(const std::filesystem::path& filed, const std::filesystem::path& computed,
                                    const std::stop_token& stop);

}  // namespace noonmark
