#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "app/cli/options/number_range.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/massing_line.h"
#include "app/cli/project/project_commands.h"
#include "scenarios/edits/building_ids.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark::cli {

namespace {

struct ExtrudeOptions : EditOptions {
    std::string lot;
    std::string on;  // a building whose footprint is the lot
    std::string id;
    bool clear = false;
    MassingSettings massing;
    double sharePercent = 0;  // 0: not given
    double areaM2 = 0;
    int podiumStoreys = 0;
    double podiumPercent = 100;
    double podiumM2 = 0;  // 0: not given
    double podiumTaperPercent = 0;
    double podiumTwistDeg = 0;
    std::vector<std::string> setbacks;  // HEIGHT:INSET[:TAPER[:TWIST]]
    double taperPercent = 0;
    std::vector<std::string> uses;  // USE:STOREYS
};

// The numbers between colons; empty where one of them is no number.
std::vector<double> numbersIn(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        const auto [next, error] = std::from_chars(at, end, numbers.emplace_back());
        if (error != std::errc{} || (next != end && *next != ':')) return {};
        if (next == end) return numbers;
        at = next + 1;
    }
}

Result<Setback> setbackFrom(const std::string& text) {
    std::vector<double> numbers = numbersIn(text);
    if (numbers.size() < 2 || numbers.size() > 4)
        return failure("It is not a setback", text,
                       "Give HEIGHT:INSET in metres, for example 60:3, or HEIGHT:INSET:TAPER:TWIST");
    numbers.resize(4);
    return Setback{numbers[0], numbers[1], {.taper = numbers[2] / 100, .twistDeg = numbers[3]}};
}

Result<FloorUse> useFrom(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    FloorUse use{text.substr(0, colon), 0};
    if (colon == text.npos || text.substr(colon + 1) == "rest") return use;
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data() + colon + 1, end, use.storeys);
    if (error == std::errc{} && last == end && use.storeys > 0) return use;
    return failure("It is not a use of storeys", text,
                   "Give USE:STOREYS, for example retail:2, or USE:rest for all storeys above");
}

// Parses each text, in order.
template <class Value>
Result<std::vector<Value>> parseAll(const std::vector<std::string>& texts,
                                    Result<Value> (*parse)(const std::string&)) {
    std::vector<Value> values;
    for (const std::string& text : texts) {
        const auto value = parse(text);
        if (!value) return tl::make_unexpected(value.error());
        values.push_back(*value);
    }
    return values;
}

Podium podiumFrom(const ExtrudeOptions& options) {
    Podium podium{options.podiumStoreys,
                  {},
                  {.taper = options.podiumTaperPercent / 100, .twistDeg = options.podiumTwistDeg}};
    if (options.podiumM2 != 0)
        podium.plate.areaM2 = options.podiumM2;
    else
        podium.plate.shareOfLot = options.podiumPercent / 100;
    return podium;
}

Result<MassingSettings> settingsFrom(const ExtrudeOptions& options) {
    MassingSettings settings = options.massing;
    if (options.sharePercent != 0) settings.plate.shareOfLot = options.sharePercent / 100;
    if (options.areaM2 != 0) settings.plate.areaM2 = options.areaM2;
    if (options.podiumStoreys != 0) settings.podium = podiumFrom(options);
    settings.walls.taper = options.taperPercent / 100;
    auto setbacks = parseAll(options.setbacks, setbackFrom);
    if (!setbacks) return tl::make_unexpected(setbacks.error());
    settings.setbacks = *std::move(setbacks);
    auto uses = parseAll(options.uses, useFrom);
    if (!uses) return tl::make_unexpected(uses.error());
    settings.uses = *std::move(uses);
    return settings;
}

// The lot, and the edits that clear it.
struct Site {
    Footprint lot;
    std::vector<Edit> edits;
    std::string note;    // hint for the user
    std::string name{};  // of the lot; empty: a building's outline
};

Site siteOn(const Footprint& lot, const City& city, bool clear) {
    std::vector<Edit> demolitions = clearing(city, lot);
    if (clear || demolitions.empty()) return {lot, std::move(demolitions), {}};
    std::vector<std::string> staying;
    for (const Edit& edit : demolitions) staying.push_back(std::get<Demolish>(edit).building);
    return {lot, {}, fmt::format("  Stays on the lot without --clear: {}\n", fmt::join(staying, ", "))};
}

// The largest piece of a building that stands in several pieces.
Footprint groundOf(const Building& building) {
    std::vector<Footprint> pieces = computeOutline(building);
    if (pieces.empty()) return building.parts.front().footprint;
    return *std::ranges::max_element(pieces, {}, [](const Footprint& piece) { return area(piece); });
}

Result<Site> siteOf(const ExtrudeOptions& options, const Project& project, const City& city) {
    if (options.on.empty()) {
        const auto lot = findLot(project, options.lot);
        if (!lot) return tl::make_unexpected(lot.error());
        Site site = siteOn(lot->outline, city, options.clear);
        site.name = lot->name;
        return site;
    }
    const auto found = findBuilding(city, options.on);
    if (!found) return tl::make_unexpected(found.error());
    const Building& old = *city.buildings[*found];
    return Site{groundOf(old), {Demolish{old.sourceId}}, {}};
}

Result<std::string> extrude(const ExtrudeOptions& options, Project& project) {
    if (const auto known = scenarioToChange(project, options.scenario); !known)
        return tl::make_unexpected(known.error());
    const auto city = cityOf(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    auto site = siteOf(options, project, city->city);
    if (!site) return tl::make_unexpected(site.error());
    const auto settings = settingsFrom(options);
    if (!settings) return tl::make_unexpected(settings.error());
    const auto massing = makeMassing(site->lot, *settings);
    if (!massing) return tl::make_unexpected(massing.error());
    const auto building = buildingOf(*massing, options.id);
    if (!building) return tl::make_unexpected(building.error());
    site->edits.emplace_back(
        AddBuilding{std::make_shared<const Building>(*building),
                    std::make_shared<const TowerDesign>(TowerDesign{site->name, site->lot, *settings})});
    return withEdits(project, options.scenario, site->edits).map([&](const std::string& words) {
        return fmt::format("{}{}: {}\n{}{}", words, options.id, lineOf(massing->figures),
                           linesOf(massing->figures.uses), site->note);
    });
}

void addWallOptions(CLI::App& command, ExtrudeOptions& options, CLI::Option* podium) {
    const auto add = [&command](const char* name, double& value, const char* help, const char* unit) {
        return command.add_option(name, value, help)->type_name(unit);
    };
    add("--taper", options.taperPercent, "How much narrower the tower is at its top, 0 to 95 %", "PERCENT");
    add("--twist", options.massing.walls.twistDeg, "Turn of the tower from its bottom to its top, clockwise",
        "DEG");
    add("--podium-taper", options.podiumTaperPercent, "The same of the podium", "PERCENT")->needs(podium);
    add("--podium-twist", options.podiumTwistDeg, "The same of the podium", "DEG")->needs(podium);
}

void addShapeOptions(CLI::App& command, ExtrudeOptions& options) {
    MassingSettings& massing = options.massing;
    CLI::Option* storeys =
        command.add_option("--storeys", massing.storeys, "Number of storeys, podium included")
            ->type_name("N");
    command.add_option("--height", massing.heightM, "Total height, m")->excludes(storeys)->type_name("M");
    command.add_option("--storey-height", massing.storeyHeightM, "Height of a storey, 2 to 10 m")
        ->capture_default_str()
        ->type_name("M");
    CLI::Option* share =
        command
            .add_option("--plate-share", options.sharePercent,
                        "Floor plate of the tower as a share of the lot, % (default: all of it)")
            ->check(within(0.1, 100))
            ->type_name("PERCENT");
    command.add_option("--plate-area", options.areaM2, "Floor plate of the tower, m2")
        ->check(within(1, 1e7))
        ->excludes(share)
        ->type_name("M2");
    CLI::Option* podium =
        command.add_option("--podium", options.podiumStoreys, "Storeys of a podium below the tower")
            ->type_name("N");
    CLI::Option* podiumShare =
        command
            .add_option("--podium-share", options.podiumPercent, "Floor plate of the podium, % of the lot")
            ->capture_default_str()
            ->needs(podium)
            ->check(within(0.1, 100))
            ->type_name("PERCENT");
    command.add_option("--podium-area", options.podiumM2, "Floor plate of the podium, m2")
        ->needs(podium)
        ->check(within(1, 1e7))
        ->excludes(podiumShare)
        ->type_name("M2");
    command
        .add_option("--setback", options.setbacks,
                    "Above HEIGHT m the walls are inset by INSET m, and taper and turn by TAPER % and TWIST "
                    "degrees up to the next setback; may be repeated")
        ->type_name("HEIGHT:INSET[:TAPER[:TWIST]]");
    command.add_option("--turn", massing.clockwiseDeg, "Turn the tower on its lot, degrees clockwise")
        ->type_name("DEG");
    addWallOptions(command, options, podium);
    command
        .add_option("--use", options.uses,
                    "What the next STOREYS storeys from the ground up are used for; `rest`: all above; may "
                    "be repeated")
        ->type_name("USE:STOREYS");
}

}  // namespace

void addProjectExtrude(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ExtrudeOptions>();
    CLI::App* command =
        addEditCommand(project, "extrude", "Build a tower on a lot in a scenario", options, extrude, run);
    CLI::Option_group* where = command->add_option_group("where");
    where->add_option("--lot", options->lot, "A lot of the project")->type_name("NAME");
    where->add_option("--on", options->on, "A building to demolish; its outline becomes the lot")
        ->type_name("BUILDING");
    where->require_option(1);
    command->add_flag("--clear", options->clear, "Demolish the buildings on the lot");
    command->add_option("--id", options->id, "Id and name of the new building")
        ->required()
        ->type_name("NAME");
    addShapeOptions(*command, *options);
}

}  // namespace noonmark::cli
