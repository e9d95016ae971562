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
    std::string setting;  ///< settings that differ from the defaults: "levels 2"; may be empty
    std::shared_ptr<const Engine> accumulator;
    bool needed = false;  ///< the report needs its time: it is never stopped early
};

/// "Inverse accrual map, levels 2"
std::string makeTitle(const Contestant& contestant);

/// The contestants.
struct StartList {
    std::vector<Contestant> contestants;
    std::vector<std::string> absent;  ///< engines that cannot run on this machine, and why
};

/// Every engine with its default settings.
StartList listDefaultEngines(const EngineList& engines);

/// Every engine with its default settings, and with each of its options, one at a time, at these multiples of
/// its default (rounded and clamped to the option's range; no setting twice).
StartList listVariedEngines(const EngineList& engines, const std::vector<double>& factors);

/// One engine with one option at the given values, in order; empty if there is no such engine or option.
std::vector<Contestant> listVariants(const EngineList& engines, std::string_view engine,
                                     std::string_view option, const std::vector<double>& values);

}  // namespace noonmark::bench
