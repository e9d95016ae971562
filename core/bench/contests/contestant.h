#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/engines/api/engine_registry.h"

namespace noonmark::bench {

/// An engine with its settings, ready to run.
struct Contestant {
    std::string engine;   ///< key: "iam"
    std::string name;     ///< "Inverse accrual map"
    std::string setting;  ///< what is not as usual: "levels 2"; empty
    std::shared_ptr<const Engine> accumulator;
    bool needed = false;  ///< its time is one that is asked for: it is let run to its end
};

/// "Inverse accrual map, levels 2"
std::string makeTitle(const Contestant& contestant);

/// Who runs.
struct StartList {
    std::vector<Contestant> contestants;
    std::vector<std::string> absent;  ///< who cannot be made on this machine, and why
};

/// Every engine as it usually is.
StartList listUsualEngines(const EngineList& engines);

/// Every engine as usual, and with each of its options, one at a time, at these multiples of its usual value
/// (rounded and clamped to what the option allows; no setting twice).
StartList listVariedEngines(const EngineList& engines, const std::vector<double>& factors);

/// One engine with one option at some values, in their order; empty where there is no such engine or option.
std::vector<Contestant> listVariants(const EngineList& engines, std::string_view engine,
                                     std::string_view option, const std::vector<double>& values);

}  // namespace noonmark::bench
