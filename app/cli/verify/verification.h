#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/report/files/read_report.h"
#include "core/study/verification/result_record.h"

namespace noonmark::cli {

enum class Verdict {
    agrees,       ///< all that was compared agrees
    differs,      ///< the inputs are those recorded, and a figure, a word or a page differs
    notComputed,  ///< inputs are missing or others: nothing was computed
};

/// What a verification found out.
struct Verification {
    std::string report;  ///< the file that was verified, as named
    std::string recordName;
    std::string program;  ///< that wrote it: "Noonmark 0.1.0"
    std::vector<FoundFile> files;
    std::vector<std::string> lookedIn;        ///< for the files: "/filed and its subfolders"
    std::optional<RecordComparison> figures;  ///< none: nothing was computed
    bool sameProgram = false;  ///< this version wrote the report: its words and pages are as they are now
    std::optional<WordComparison> printed;  ///< none: nothing was computed, or the file is no PDF
    std::optional<PageComparison> pages;    ///< none: as before, or another version wrote it
    std::vector<TableComparison> tables;    ///< that lie beside the report
    std::vector<std::string> notCompared;   ///< "shadow.tif", "how the pages look"

    [[nodiscard]] Verdict verdict() const;
};

/// Keys: report, record, program, verdict ("agrees", "differs", "not computed"), inputs (path, sha256,
/// needed, found, agrees, saved_again), looked_in, figures (compared, differences of key, recorded,
/// computed), printed (figures, differences of before, recorded, computed), pages (compared, different,
/// only_in_one), tables (name, compared, differences), not_compared.
nlohmann::ordered_json verificationJson(const Verification& verification);

/// The same for people.
std::string describe(const Verification& verification);

}  // namespace noonmark::cli
