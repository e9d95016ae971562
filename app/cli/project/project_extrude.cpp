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
    double podiumM2 = 0;                // 0: not given
    std::vector<std::string> setbacks;  // HEIGHT:INSET
};

Result<Setback> setbackFrom(const std::string& text) {
    Setback setback;
    const char* const end = text.data() + text.size();
    const auto [colon, first] = std::from_chars(text.data(), end, setback.aboveM);
    if (first == std::errc{} && colon != end && *colon == ':') {
        const auto [last, second] = std::from_chars(colon + 1, end, setback.insetM);
        if (second == std::errc{} && last == end) return setback;
    }
    return failure("It is not a setback", text, "Give HEIGHT:INSET in metres, for example 60:3");
}

Podium podiumFrom(const ExtrudeOptions& options) {
    Podium podium{options.podiumStoreys, {}};
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
    for (const std::string& text : options.setbacks) {
        const auto setback = setbackFrom(text);
        if (!setback) return tl::make_unexpected(setback.error());
        settings.setbacks.push_back(*setback);
    }
    return settings;
}

// The lot, and the edits that clear it.
struct Site {
    Footprint lot;
    std::vector<Edit> edits;
    std::string note;  // hint for the user
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
        return siteOn(lot->outline, city, options.clear);
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
    const auto massing = settingsFrom(options).and_then(
        [&](const MassingSettings& settings) { return makeMassing(site->lot, settings); });
    if (!massing) return tl::make_unexpected(massing.error());
    const auto building = buildingOf(*massing, options.id);
    if (!building) return tl::make_unexpected(building.error());
    site->edits.emplace_back(AddBuilding{std::make_shared<const Building>(*building)});
    return withEdits(project, options.scenario, site->edits).map([&](const std::string& words) {
        return fmt::format("{}{}: {}\n{}", words, options.id, lineOf(massing->figures), site->note);
    });
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
                    "Above HEIGHT m the walls are inset by INSET m; may be repeated")
        ->type_name("HEIGHT:INSET");
    command.add_option("--turn", massing.clockwiseDeg, "Turn the tower on its lot, degrees clockwise")
        ->type_name("DEG");
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
