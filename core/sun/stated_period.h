#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/sun/period.h"

namespace noonmark {

/// The period of a result, for whoever states it in words of their own language.
struct StatedPeriod {
    std::string words{};            ///< in English, as files have it; empty: not known
    std::optional<Period> asked{};  ///< none: the version that saved the result stated words alone

    bool operator==(const StatedPeriod&) const = default;
};

StatedPeriod statePeriod(const Period& period);

/// Of `period` in the JSON of an answer, or of the fields of a period alone (fieldsJson()). Members of
/// another kind count as not stated.
StatedPeriod readStatedPeriod(const nlohmann::ordered_json& json);

}  // namespace noonmark
