#include "app/gui/base/widgets/number_text.h"

#include <QLocale>
#include <QObject>
#include <QRegularExpression>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/language/translated_text.h"
#include "core/city/city.h"
#include "core/geo/frame.h"

namespace noonmark {

QString groupDigits(double number, int decimals) {
    const QString text = QLocale().toString(number, 'f', decimals);
    // What rounds to zero has no sign.
    const double unit = std::pow(10, -decimals);
    return number < 0 && std::abs(number) < unit / 2 ? QLocale().toString(0.0, 'f', decimals) : text;
}

QString withPlus(double value, const QString& text) {
    static const QRegularExpression digit(QStringLiteral("[1-9]"));
    const bool isShown = text.section(QLatin1Char(' '), 0, 0).contains(digit);
    return (value > 0 && isShown ? QStringLiteral("+") : QString()) + text;
}

QString formatAmount(double number, int decimals) {
    QString text = groupDigits(number, decimals);
    const QString point = QLocale().decimalPoint(), zero = QLocale().zeroDigit();
    if (decimals <= 0 || !text.contains(point)) return text;
    while (text.endsWith(zero)) text.chop(zero.size());
    if (text.endsWith(point)) text.chop(point.size());
    return text;
}

QString formatCount(quint64 number) { return QLocale().toString(number); }

// Languages choose the form by the last digits, so a count too large for tr() keeps them.
int pluralNumber(quint64 count) {
    return count < 1'000'000 ? int(count) : int(1'000'000 + count % 1'000'000);
}

QString formatShort(double number, int digits) { return QLocale().toString(number, 'g', digits); }

QString describeLength(double metres, int decimals) {
    return localiseNumbers(QString::fromStdString(formatLength(metres, unitsInUse(), decimals)));
}

QString describeArea(double squareMetres) {
    return localiseNumbers(QString::fromStdString(formatArea(squareMetres, unitsInUse())));
}

QString describeSmallArea(double squareMetres) {
    return localiseNumbers(QString::fromStdString(formatSmallArea(squareMetres, unitsInUse())));
}

QString localiseNumbers(const QString& text) { return localiseNumbers(text, QLocale()); }

double computeElevation(const City& city, glm::dvec3 local) {
    const double dropM = city.terrain ? earthDropM({local.x, local.y}) : 0;
    return local.z + city.frame.originElevationM() + dropM;
}

double heightZeroM(double groundElevationM) {
    return heightReferenceInUse() == HeightReference::datum ? groundElevationM : 0;
}

QString describeHeight(double aboveGroundM, double groundElevationM) {
    const QString text = describeLength(aboveGroundM + heightZeroM(groundElevationM));
    return heightReferenceInUse() == HeightReference::datum ? QObject::tr("%1 above datum").arg(text)
                                                            : QObject::tr("%1 above ground").arg(text);
}

QString keepUnits(QString text) {
    static const QRegularExpression unit(
        QStringLiteral("(?<=\\d) (?=(?:%|°|h|min|s|m|m²|km|ha|ft|sq ft)(?:\\W|$))"));
    return text.replace(unit, QString(QChar(QChar::Nbsp)));
}

QString shortDay() { return QObject::tr("d MMM"); }
QString longDay() { return QObject::tr("d MMMM"); }
QString dayOfYear() { return QObject::tr("d MMM yyyy"); }
QString longDate() { return QObject::tr("d MMMM yyyy"); }

namespace {

QString describeHoursOfDay(const Period& period) {
    const auto text = [](const std::string& words) { return QString::fromStdString(words); };
    if (period.window == SolarHours{}) return QObject::tr("sunrise to sunset");
    if (period.window) return text(formatText(*period.window));
    if (period.hours == 0) return text(formatText(period.from));
    const std::chrono::minutes end = period.from + std::chrono::minutes(std::lround(60 * period.hours));
    return QObject::tr("%1 to %2").arg(text(formatText(period.from)), text(formatText(end)));
}

/// 1 to 12; 0: no month begins like this.
int parseMonth(const QString& name) {
    constexpr int minLetters = 3;
    if (name.size() < minLetters) return 0;
    for (const QLocale& locale : {QLocale(), QLocale::c()})
        for (int month = 1; month <= 12; ++month)
            for (const QString& known : {locale.monthName(month, QLocale::LongFormat),
                                         locale.monthName(month, QLocale::ShortFormat)})
                if (known.startsWith(name, Qt::CaseInsensitive)) return month;
    return 0;
}

}  // namespace

QString describeWhen(const Period& period) {
    const auto text = [](QDate date) { return QLocale().toString(date, longDate()); };
    const QDate first = dateOf(period.start);
    const QString days = period.days == 1
                             ? text(first)
                             : QObject::tr("%1 to %2").arg(text(first), text(first.addDays(period.days - 1)));
    return QObject::tr("%1, %2").arg(days, describeHoursOfDay(period));
}

QString periodText(const Period& period) {
    const bool isMoment = !period.window && period.hours == 0;
    QStringList parts{describeWhen(period)};
    if (!isMoment) parts << QObject::tr("every %1 min").arg(formatShort(period.stepMinutes, 3));
    parts << QString::fromStdString(period.zone);
    if (!period.refraction) parts << QObject::tr("no refraction");
    return parts.join(QStringLiteral(", "));
}

QString periodText(const StatedPeriod& stated) {
    return stated.asked ? periodText(*stated.asked) : QString::fromStdString(stated.words);
}

QDate parseDay(const QString& text, QDate shown) {
    static const QRegularExpression dayName(QStringLiteral(R"(^(\d{1,2})\.?\s*(\p{L}+)\.?$)")),
        nameDay(QStringLiteral(R"(^(\p{L}+)\.?\s*(\d{1,2})\.?$)")),
        dots(QStringLiteral(R"(^(\d{1,2})\.(\d{1,2})\.?$)")),
        iso(QStringLiteral(R"(^(?:\d{4}-)?(\d{1,2})-(\d{1,2})$)")), day(QStringLiteral(R"(^(\d{1,2})\.?$)"));
    const QString typed = text.simplified();
    const auto in = [&](int month, const QString& of) { return QDate(shown.year(), month, of.toInt()); };
    if (const auto match = dayName.match(typed); match.hasMatch())
        return in(parseMonth(match.captured(2)), match.captured(1));
    if (const auto match = nameDay.match(typed); match.hasMatch())
        return in(parseMonth(match.captured(1)), match.captured(2));
    if (const auto match = dots.match(typed); match.hasMatch())
        return in(match.captured(2).toInt(), match.captured(1));
    if (const auto match = iso.match(typed); match.hasMatch())
        return in(match.captured(1).toInt(), match.captured(2));
    const auto match = day.match(typed);
    return match.hasMatch() ? in(shown.month(), match.captured(1)) : QDate();
}

QTime parseTime(const QString& text) {
    for (const char* format : {"H:mm", "H.mm", "HHmm", "H"})
        if (const QTime time = QTime::fromString(text.trimmed(), QLatin1String(format)); time.isValid())
            return time;
    return {};
}

QDate dateOf(CivilDate date) {
    return {int(date.year()), int(unsigned(date.month())), int(unsigned(date.day()))};
}

CivilDate civilOf(QDate date) {
    return {std::chrono::year{date.year()}, std::chrono::month{unsigned(date.month())},
            std::chrono::day{unsigned(date.day())}};
}

namespace {

QString inUnits(const QString& metric, const QString& imperial) {
    switch (unitsInUse()) {
        case UnitSystem::metric:
            return metric;
        case UnitSystem::imperial:
            return imperial;
        case UnitSystem::both:
            break;
    }
    return QStringLiteral("%1 (%2)").arg(metric, imperial);
}

}  // namespace

QString areaUnit() { return inUnits(QStringLiteral("m²"), QObject::tr("sq ft")); }

QString lengthUnit() { return inUnits(QStringLiteral("m"), QObject::tr("ft")); }

QString areaNumber(double squareMetres) {
    return inUnits(groupDigits(squareMetres), groupDigits(squareMetres / squareMetresPerSquareFoot));
}

QString lengthNumber(double metres) {
    return inUnits(groupDigits(metres, 1), groupDigits(metres / metresPerFoot, 1));
}

QString signedAreaNumber(double squareMetres) { return withPlus(squareMetres, areaNumber(squareMetres)); }

}  // namespace noonmark
