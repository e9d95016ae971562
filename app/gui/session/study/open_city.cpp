#include "app/gui/session/study/open_city.h"

#include <QDateTime>
#include <QFile>
#include <QRegularExpression>
#include <QTimeZone>
#include <limits>

#include "app/input/all_engines.h"
#include "core/geo/lon_lat.h"
#include "core/sun/zone_country.h"
#include "render/scene/crown_bodies.h"
#include "render/view/traced_city.h"

namespace noonmark {

namespace {

constexpr double nearbyM = 30000;  // size of a large city

// Digits are dd, ddmm or ddmmss; longitudes have one digit of degrees more.
double degreesOf(QStringView digits, int degreeDigits) {
    double degrees = digits.left(degreeDigits).toInt();
    degrees += digits.mid(degreeDigits, 2).toInt() / 60.0;
    return degrees + digits.mid(degreeDigits + 2, 2).toInt() / 3600.0;
}

struct NearestCity {
    const ZoneCity* city = nullptr;
    double metres = std::numeric_limits<double>::infinity();

    void look(const std::vector<ZoneCity>& cities, LonLat place) {
        for (const ZoneCity& one : cities) {
            const double away = computeGreatCircleM(one.place, place);
            if (away >= metres) continue;
            city = &one;
            metres = away;
        }
    }
};

// Compares the first day of each month: enough to distinguish daylight saving rules.
bool showTheSameTime(const QString& one, const QString& other) {
    if (one == other) return true;
    const QTimeZone a(one.toUtf8()), b(other.toUtf8());
    if (!a.isValid() || !b.isValid()) return false;
    for (int month = 1; month <= 12; ++month) {
        const QDateTime at(QDate(2026, month, 1), QTime(12, 0), Qt::UTC);
        if (a.offsetFromUtc(at) != b.offsetFromUtc(at)) return false;
    }
    return true;
}

void addOthers(ZoneGuess& guess, const std::vector<ZoneCity>& cities, LonLat place, double withinM) {
    for (const ZoneCity& city : cities)
        if (!guess.others.contains(city.zone) && computeGreatCircleM(city.place, place) <= withinM &&
            !showTheSameTime(city.zone, guess.zone))
            guess.others << city.zone;
}

}  // namespace

std::optional<LonLat> parseIso6709(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^([+-])(\\d{4}|\\d{6})([+-])(\\d{5}|\\d{7})$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    const auto sign = [&match](int group) {
        return match.captured(group) == QLatin1String("-") ? -1.0 : 1.0;
    };
    return LonLat{sign(3) * degreesOf(match.captured(4), 3), sign(1) * degreesOf(match.captured(2), 2)};
}

std::vector<ZoneCity> zoneCities(QTextStream& table) {
    std::vector<ZoneCity> cities;
    for (QString line; table.readLineInto(&line);) {
        const QStringList fields = line.split(QLatin1Char('\t'));
        if (line.startsWith(QLatin1Char('#')) || fields.size() < 3) continue;
        if (const auto place = parseIso6709(fields[1])) cities.push_back({*place, fields[0], fields[2]});
    }
    return cities;
}

ZoneGuess guessZone(const std::vector<ZoneCity>& principal, const std::vector<ZoneCity>& cities,
                    LonLat place) {
    NearestCity first, nearest;
    first.look(principal, place);
    nearest.look(principal, place);
    nearest.look(cities, place);
    if (nearest.city == nullptr) return {};
    const bool principalCounts = first.metres <= nearbyM && first.city->country == nearest.city->country;
    ZoneGuess guess{principalCounts ? first.city->zone : nearest.city->zone, {}};
    const double withinM = nearest.metres + nearbyM;
    addOthers(guess, principal, place, withinM);
    if (!principalCounts) addOthers(guess, cities, place, withinM);
    return guess;
}

namespace {

std::vector<ZoneCity> gazetteerCities() {
    std::vector<ZoneCity> cities;
    for (const Town& town : listTowns())
        if (!town.zone.empty())
            cities.push_back(
                {town.place, QString::fromStdString(town.country), QString::fromStdString(town.zone)});
    return cities;
}

}  // namespace

ZoneGuess findNearestZone(LonLat place) {
    QFile file(QStringLiteral("/usr/share/zoneinfo/zone.tab"));
    std::vector<ZoneCity> principal;
    if (file.open(QIODevice::ReadOnly | QIODevice::Text)) {
        QTextStream table(&file);
        principal = zoneCities(table);
    }
    return guessZone(principal, gazetteerCities(), place);
}

namespace {

// If more buildings than this differ from the arrays, new arrays are made: drawing them separately would cost
// at each change.
constexpr std::size_t maxAdded = 1000;

bool serves(const std::shared_ptr<const CityArrays>& drawn, const City& city) {
    return drawn && computeDifference(*drawn, city).added.buildings.size() <= maxAdded;
}

}  // namespace

Result<std::shared_ptr<const CrownRays>> findCrownRays(const City& city,
                                                       std::shared_ptr<const CrownRays> known,
                                                       const std::stop_token& stop) {
    if (!city.trees || city.trees->trees.empty() || !drawsInSoftware())
        return std::shared_ptr<const CrownRays>();
    return known && known->trees == city.trees ? std::move(known) : makeCrownRays(city.trees, stop);
}

Result<OpenCity> shownCity(LoadedCity loaded, std::shared_ptr<const CityArrays> drawn,
                           std::shared_ptr<const CrownRays> crowns, Progress& progress,
                           const std::stop_token& stop) {
    progress.report(0.9, "building the view");
    OpenCity open{std::move(loaded), std::move(drawn), {}, {}};
    if (!serves(open.arrays, open.city()))
        open.arrays = std::make_shared<const CityArrays>(makeArrays(open.city()));
    if (stop.stop_requested()) return cancelled();
    auto scene = RayScene::over(open.city(), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    auto rays = findCrownRays(open.city(), std::move(crowns), stop);
    if (!rays) return tl::make_unexpected(rays.error());
    open.crowns = *std::move(rays);
    open.picker = ScenePicker(open.city(), *std::move(scene));
    return open;
}

StudySettings firstSettings(const LoadedCity& loaded, const ZoneGuess& zone) {
    StudySettings settings;
    settings.region = firstRegion(loaded);
    settings.receivers.cellM = 2;
    settings.period.zone = zone.zone.toStdString();
    return settings;
}

Result<Study> studyOf(const LoadedCity& loaded, const StudySettings& settings, Progress& progress,
                      std::stop_token stop) {
    auto study =
        runStudy(loaded.read.city, settings, progress, std::move(stop), enginesWith(settings.engine));
    if (study) addReading(*study, loaded);
    return study;
}

}  // namespace noonmark
