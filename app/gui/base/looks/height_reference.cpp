#include "app/gui/base/looks/height_reference.h"

#include <QCoreApplication>
#include <QSettings>
#include <QVariant>

namespace noonmark {

namespace {

const QString aboveDatumKey = QStringLiteral("heightsAboveDatum");
constexpr const char* aboveDatumProperty = "heightsAboveDatum";

}  // namespace

HeightReference readHeightReference(const QSettings& settings) {
    return settings.value(aboveDatumKey).toBool() ? HeightReference::datum : HeightReference::ground;
}

void saveHeightReference(HeightReference reference, QSettings& settings) {
    settings.setValue(aboveDatumKey, reference == HeightReference::datum);
}

void applyHeightReference(HeightReference reference) {
    QCoreApplication::instance()->setProperty(aboveDatumProperty, reference == HeightReference::datum);
}

HeightReference heightReferenceInUse() {
    const QCoreApplication* application = QCoreApplication::instance();
    const bool datum = application && application->property(aboveDatumProperty).toBool();
    return datum ? HeightReference::datum : HeightReference::ground;
}

}  // namespace noonmark
