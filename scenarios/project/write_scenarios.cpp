#include <fmt/format.h>

#include <algorithm>

#include "scenarios/project/edit_json.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/write_project.h"

namespace noonmark {

namespace {

// The building that an edit adds, for the layer of proposals; heights are above the ground.
struct BuiltBy {
    NewShape operator()(const Replace& edit) const { return edit.with; }
    NewShape operator()(const AddBuilding& edit) const { return edit.building; }
    NewShape operator()(const ImportMesh& edit) const {
        return std::make_shared<const Building>(placeBuilding(*edit.shape, edit.placement));
    }
    template <class Other>
    NewShape operator()(const Other&) const {
        return nullptr;
    }
};

class ScenarioWriter {
public:
    explicit ScenarioWriter(Database& database)
        : database_(database),
          addEdit_(database.prepare(
              "INSERT INTO edits (scenario, position, kind, words, value) VALUES (?, ?, ?, ?, ?)")),
          addProposal_(database.prepare(
              "INSERT INTO proposals (geom, scenario, building_id, name, height, min_height, edit) "
              "VALUES (?, ?, ?, ?, ?, ?, ?)")) {}

    // Edits before `first` are already in the tables.
    void write(std::size_t id, const Scenario& scenario, std::size_t first) {
        cut(id, first);
        database_.prepare("DELETE FROM scenarios WHERE id = ?").run(id);
        database_.prepare("INSERT INTO scenarios (id, name, base) VALUES (?, ?, ?)")
            .run(id, scenario.name, scenario.base);
        for (std::size_t i = first; i < scenario.edits.size(); ++i) {
            const Edit& edit = scenario.edits[i];
            addEdit_.run(id, i, getKind(edit), formatText(edit), toJson(edit));
            addProposals(database_.lastRow(), scenario.name, std::visit(BuiltBy{}, edit));
        }
    }

    void remove(std::size_t id) {
        cut(id, 0);
        database_.prepare("DELETE FROM scenarios WHERE id = ?").run(id);
    }

private:
    void cut(std::size_t id, std::size_t first) {
        database_
            .prepare(
                "DELETE FROM proposals WHERE edit IN (SELECT id FROM edits WHERE scenario = ? AND position "
                ">= ?)")
            .run(id, first);
        database_.prepare("DELETE FROM edits WHERE scenario = ? AND position >= ?").run(id, first);
    }

    void addProposals(std::int64_t edit, const std::string& scenario, const NewShape& built) {
        if (!built) return;
        for (const Part& part : built->parts)
            addProposal_.run(AsBlob{polygonBlob(part.footprint)}, scenario, built->sourceId, built->name,
                             part.topM, part.bottomM, edit);
    }

    Database& database_;
    Statement addEdit_, addProposal_;
};

// Number of equal edits at the start of both lists, which need not be written.
std::size_t sharedEdits(const Scenario& before, const Scenario& after) {
    if (before.name != after.name) return 0;
    const auto [old, made] = std::ranges::mismatch(before.edits, after.edits);
    return std::size_t(made - after.edits.begin());
}

// Another program may have deleted or numbered rows.
bool areNumbered(Database& database, std::size_t scenarios) {
    const auto rows = database.value(
        "SELECT count(*) || ' ' || ifnull(min(id), 1) || ' ' || ifnull(max(id), 0) FROM scenarios");
    return rows == fmt::format("{0} 1 {0}", scenarios);
}

void clearScenarios(Database& database) {
    database.execute("DELETE FROM proposals; DELETE FROM edits; DELETE FROM scenarios");
}

}  // namespace

void writeScenarios(Database& database, const std::vector<Scenario>& before,
                    const std::vector<Scenario>& after) {
    if (!areNumbered(database, before.size())) {
        clearScenarios(database);
        if (!before.empty()) return writeScenarios(database, {}, after);
    }
    ScenarioWriter writer(database);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool was = i < before.size();
        if (was && before[i] == after[i]) continue;
        writer.write(i + 1, after[i], was ? sharedEdits(before[i], after[i]) : 0);
    }
    for (std::size_t i = after.size(); i < before.size(); ++i) writer.remove(i + 1);
    database.execute(
        "UPDATE gpkg_contents SET last_change = strftime('%Y-%m-%dT%H:%M:%fZ','now') WHERE table_name = "
        "'proposals'");
}

}  // namespace noonmark
