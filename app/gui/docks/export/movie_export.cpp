#include "app/gui/docks/export/movie_export.h"

#include "core/io/shadows/drawn_times.h"

namespace noonmark {

namespace {

Result<std::vector<DrawnTime>> listTimes(const MovieSource& source, const MovieChoice& choice) {
    DrawnTimeChoice when{{formatText(choice.date)}, {formatText(choice.at)}, 0, source.zone};
    if (choice.kind == MovieChoice::Kind::day) {
        when.times.clear();
        when.everyMin = choice.everyMin;
    }
    if (choice.kind == MovieChoice::Kind::year) when.days = listDaysOf(int(choice.date.year()));
    Warnings nights;  // days without sun at that time have no frame
    return listDrawnTimes(when, *source.baseline, nights);
}

}  // namespace

Result<MovieFacts> exportMovie(const MovieSource& source, const MovieChoice& choice,
                               const std::filesystem::path& file, Progress& progress,
                               const std::stop_token& stop) {
    if (const auto may = checkOutput(file, OutputKind::movie, source.outputs); !may)
        return tl::make_unexpected(may.error());
    auto times = listTimes(source, choice);
    if (!times) return tl::make_unexpected(times.error());
    ShadowMovie movie{*source.baseline,      source.scenario.get(),
                      source.places,         *std::move(times),
                      {.area = source.area}, choice.title,
                      source.attribution,    choice.kind == MovieChoice::Kind::swipe,
                      choice.format};
    return writeShadowMovie(movie, file, progress, stop);
}

}  // namespace noonmark
