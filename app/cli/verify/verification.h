#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/study/verification/compare_records.h"
#include "core/study/verification/compare_words.h"
#include "core/study/verification/find_inputs.h"

namespace noonmark::cli {

enum class Verdict {
    agrees,       ///< every compared figure agrees
    differs,      ///< the inputs are those recorded, and a figure differs
    notComputed,  ///< inputs are missing or others: nothing was computed
};

/// What a verification found out.
struct Verification {
    std::string report;  ///< the file that was verified, as named
    std::string recordName;
    std::string program;  ///< that wrote it: "Noonmark 0.1.0"
    std::vector<FoundFile> files;
    std::optional<RecordComparison> figures;  ///< none: nothing was computed
    std::optional<WordComparison> printed;    ///< none: nothing was computed, or the file is no PDF

    [[nodiscard]] Verdict verdict() const;
};

/// Keys: report, record, program, verdict ("agrees", "differs", "not computed"), inputs (path, sha256,
/// needed, found, agrees), figures (compared, differences of key, recorded, computed), printed (figures,
/// differences of before, recorded, computed).
nlohmann::ordered_json verificationJson(const Verification& verification);

/// The same for people.
std::string describe(const Verification& verification);

}  // namespace noonmark::cli
