#include "core/bench/contests/contestant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace noonmark::bench {

namespace {

double standardOf(const Field& option) { return asNumber(option.standard).value_or(0); }

std::string describeSetting(const Field& option, double value) {
    if (value == standardOf(option)) return {};
    return fmt::format("{} {:g}{}{}", option.key, value, option.unit.empty() ? "" : " ", option.unit);
}

double clampToRange(const Field& option, double value) {
    const ValueRange range = option.range.value_or(ValueRange{0, 1});  // yes or no
    value = std::clamp(value, range.min, range.max);
    return option.kind != ValueKind::number ? std::round(value) : value;
}

void add(StartList& list, const EngineEntry& engine, const EngineSettings& settings, std::string words,
         const EngineList& engines) {
    auto made = makeEngine(engine.info.key, settings, engines);
    if (made)
        list.contestants.push_back({std::string(engine.info.key), std::string(engine.info.name),
                                    std::move(words), std::move(*made)});
    else
        list.absent.push_back(fmt::format("{}: {}", engine.info.key, made.error().text()));
}

void addLadder(StartList& list, const EngineEntry& engine, const Field& option, std::vector<double> values,
               const EngineList& engines) {
    for (double& value : values) value = clampToRange(option, value);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    for (const double value : values)
        add(list, engine, {{std::string(option.key), value}}, describeSetting(option, value), engines);
}

}  // namespace

std::string makeTitle(const Contestant& contestant) {
    return contestant.name + (contestant.setting.empty() ? "" : ", ") + contestant.setting;
}

StartList listDefaultEngines(const EngineList& engines) {
    StartList list;
    for (const EngineEntry& engine : engines) add(list, engine, {}, {}, engines);
    return list;
}

StartList listVariedEngines(const EngineList& engines, const std::vector<double>& factors) {
    StartList list;
    for (const EngineEntry& engine : engines) {
        const std::size_t absent = list.absent.size();
        add(list, engine, {}, {}, engines);
        if (list.absent.size() > absent) continue;
        for (const Field& option : engine.info.options) {
            std::vector<double> values;
            for (const double factor : factors) values.push_back(factor * standardOf(option));
            std::erase_if(values,
                          [&](double value) { return clampToRange(option, value) == standardOf(option); });
            addLadder(list, engine, option, values, engines);
        }
    }
    return list;
}

std::vector<Contestant> listVariants(const EngineList& engines, std::string_view engine,
                                     std::string_view option, const std::vector<double>& values) {
    StartList list;
    if (const EngineEntry* found = findEngine(engines, engine))
        for (const Field& known : found->info.options)
            if (known.key == option) addLadder(list, *found, known, values, engines);
    return list.contestants;
}

}  // namespace noonmark::bench
