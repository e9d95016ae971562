#include "app/gui/base/looks/units.h"

#include <QCoreApplication>
#include <QSettings>
#include <QVariant>

namespace noonmark {

namespace {

const QString unitsKey = QStringLiteral("units");
constexpr const char* unitsProperty = "units";

}  // namespace

UnitSystem readUnits(const QSettings& settings) {
    return parseUnitSystem(settings.value(unitsKey).toString().toStdString()).value_or(UnitSystem::metric);
}

void saveUnits(UnitSystem units, QSettings& settings) {
    const std::string_view name = nameOf(units);
    settings.setValue(unitsKey, QString::fromLatin1(name.data(), qsizetype(name.size())));
}

void applyUnits(UnitSystem units) { QCoreApplication::instance()->setProperty(unitsProperty, int(units)); }

UnitSystem unitsInUse() {
    const QCoreApplication* application = QCoreApplication::instance();
    return application ? UnitSystem(application->property(unitsProperty).toInt()) : UnitSystem::metric;
}

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
