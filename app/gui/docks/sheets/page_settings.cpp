#include "app/gui/docks/sheets/page_settings.h"

#include <QLocale>
#include <QSettings>

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

}  // namespace noonmark
