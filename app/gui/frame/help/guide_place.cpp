#include "app/gui/frame/help/guide_place.h"

#include <QWidget>

namespace noonmark {

namespace {

/// A dock or bar by its object name, a dialog by its class.
struct PlaceOfPart {
    const char* part;
    const char* page;
    const char* section;
};

constexpr PlaceOfPart places[] = {
    {"studyDock", "window", "A study"},
    {"elementsDock", "window", "Facades, windows, planes"},
    {"placesDock", "window", "Sun by place"},
    {"resultsDock", "results", "Figures"},
    {"contributionsDock", "window", "Contributions"},
    {"scenariosDock", "window", "Scenarios"},
    {"projectDock", "window", "Scenarios"},
    {"weightsDock", "results", "A score"},
    {"warningsDock", "data", ""},
    {"reviewDock", "window", "Review by a rule"},
    {"pointDock", "window", "Sun and time"},
    {"timeStrip", "window", "Sun and time"},
    {"buildingDock", "window", "Changing buildings"},
    {"towerDock", "window", "Changing buildings"},
    {"modeBar", "window", "Modes"},
    {"noonmark::TimeStrip", "window", "Sun and time"},
    {"noonmark::LegendStrip", "window", "Scenarios"},
    {"noonmark::ExportDialog", "window", "Export"},
    {"noonmark::MovieDialog", "window", "Export"},
    {"noonmark::OpenOptions", "data", ""},
    {"noonmark::LotRoadsDialog", "review", "Rules"},
    {"noonmark::PhotographDialog", "data", "Aerial photograph"},
    {"noonmark::TileDialog", "data", "Aerial photograph"},
    {"noonmark::PreferencesDialog", "window", "Preferences"},
};

}  // namespace

GuidePlace findGuidePlace(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget())
        for (const PlaceOfPart& place : places)
            if (widget->objectName() == QLatin1String(place.part) ||
                qstrcmp(widget->metaObject()->className(), place.part) == 0)
                return {QString::fromLatin1(place.page), QString::fromLatin1(place.section)};
    return {QStringLiteral("window"), {}};
}

QString guideLink(const GuidePlace& place) {
    return QStringLiteral("guide:") + place.page + QLatin1Char('#') + place.section;
}

GuidePlace parseGuideLink(const QString& link) {
    const QString rest = link.mid(int(qstrlen("guide:")));
    return {rest.section(QLatin1Char('#'), 0, 0), rest.section(QLatin1Char('#'), 1)};
}

}  // namespace noonmark
