#include "app/gui/frame/help/start_settings.h"

#include <QSettings>

namespace noonmark {

namespace {

const QString showStartKey = QStringLiteral("showStart");

}  // namespace

bool readShowStart(const QSettings& settings) { return settings.value(showStartKey, true).toBool(); }

void saveShowStart(bool shows, QSettings& settings) { settings.setValue(showStartKey, shows); }

}  // namespace noonmark
