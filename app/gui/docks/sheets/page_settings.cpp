#include "app/gui/docks/sheets/page_settings.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

#include "app/gui/session/project/project_session.h"

namespace noonmark {

namespace {

const QString paperKey = QStringLiteral("sheets/paper"), landscapeKey = QStringLiteral("sheets/landscape");

}  // namespace

PageSetup readPageSetup(const QSettings& settings) {
    const auto saved = parsePaper(settings.value(paperKey).toString().toStdString());
    const bool isMetric = QLocale::system().measurementSystem() == QLocale::MetricSystem;
    return {saved.value_or(isMetric ? Paper::a4 : Paper::letter), settings.value(landscapeKey).toBool()};
}

void savePageSetup(const PageSetup& setup, QSettings& settings) {
    settings.setValue(paperKey, QString::fromStdString(std::string(nameOf(setup.paper))));
    settings.setValue(landscapeKey, setup.landscape);
}

void saveTitleBlock(const BookSettings& chosen, ProjectSession& session) {
    Project next = session.project();
    const SheetSettings sheets{chosen.titleBlock, chosen.units};
    if (next.sheets == sheets) return;
    next.sheets = sheets;
    session.change(std::move(next), QCoreApplication::translate("noonmark::SheetsDialog", "Title block"));
}

}  // namespace noonmark
