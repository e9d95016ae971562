#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/csv_text.h"
#include "core/describe/figure_text.h"
#include "core/receivers/place_names.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/provenance/source_columns.h"
#include "core/study/text/warnings_json.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* keptKey = "contributions_of_places";

Json rowsJson(const std::vector<Contribution>& rows) {
    Json json = Json::array();
    for (const Contribution& one : rows) {
        json.push_back({{"source_id", one.id}, {"name", one.name}});
        json.back().update(figuresJson(contributionFigures().of(one)));
    }
    return json;
}

std::vector<Contribution> parseRows(const Json& json) {
    std::vector<Contribution> rows;
    for (const Json& one : json) {
        rows.push_back(readFigures(contributionFigures(), one));
        rows.back().id = one.at("source_id");
        rows.back().name = one.at("name");
    }
    return rows;
}

}  // namespace

KeptContributions keepContributions(const PlaceContributions& of, double sunlitMinutesPerDay) {
    return {of.place.name,       std::string(nameOf(of.place.kind)),
            of.breakdown.engine, of.cells,
            sunlitMinutesPerDay, of.rows};
}

std::vector<KeptContributions> withContributions(std::vector<KeptContributions> all, KeptContributions more) {
    std::erase_if(all, [&](const KeptContributions& old) { return old.place == more.place; });
    all.push_back(std::move(more));
    return all;
}

std::string withContributions(std::string json, const std::vector<KeptContributions>& all) {
    if (all.empty()) return json;
    Json answer = Json::parse(json);
    answer[keptKey] = Json::array();
    for (const KeptContributions& of : all)
        answer[keptKey].push_back({{"place", of.place},
                                   {"kind", of.kind},
                                   {"engine", of.engine},
                                   {"cells", of.cells},
                                   {"sunlit_min_per_day", of.sunlitMinutesPerDay},
                                   {"buildings", rowsJson(of.rows)}});
    return toJsonText(answer);
}

std::vector<KeptContributions> parseContributions(const Json& answer) {
    std::vector<KeptContributions> all;
    for (const Json& of : answer.value(keptKey, Json::array()))
        all.push_back({of.at("place"), of.at("kind"), of.at("engine"), of.at("cells"),
                       of.at("sunlit_min_per_day"), parseRows(of.at("buildings"))});
    return all;
}

std::string contributionsCsv(const std::vector<KeptContributions>& all, const Provenance& provenance) {
    std::vector<std::string> columns{"place", "kind", "source_id", "name"};
    for (std::string& key : listColumns(contributionFigures().rows())) columns.push_back(std::move(key));
    CsvText csv(withSourceColumns(std::move(columns)));
    const SourceValues source = sourceValues(provenance);
    for (const KeptContributions& of : all)
        for (const Contribution& row : of.rows) {
            csv.text(of.place).text(of.kind).text(row.id).text(row.name);
            addFigures(csv, contributionFigures().of(row));
            addSource(csv, source);
            csv.endRow();
        }
    return csv.take();
}

}  // namespace noonmark
