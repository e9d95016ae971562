#include "app/gui/base/widgets/name_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QObject>

#include "app/gui/base/widgets/error_text.h"
#include "core/study/contributions/contributions.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

// Of resources/rules, and the countries that they are grouped by.
[[maybe_unused]] constexpr const char* ruleNames[] = {
    QT_TRANSLATE_NOOP("Rule", "Boston, Article 80 diagrams"),
    QT_TRANSLATE_NOOP("Rule", "Boston"),
    QT_TRANSLATE_NOOP("Rule", "Boston, Common and Garden"),
    QT_TRANSLATE_NOOP("Rule", "Boston, Midtown"),
    QT_TRANSLATE_NOOP("Rule", "BRE 209 (2022), amenity space"),
    QT_TRANSLATE_NOOP("Rule", "London"),
    QT_TRANSLATE_NOOP("Rule", "BRE 209 (2022), windows"),
    QT_TRANSLATE_NOOP("Rule", "New York, CEQR chapter 8"),
    QT_TRANSLATE_NOOP("Rule", "New York"),
    QT_TRANSLATE_NOOP("Rule", "China, GB 50180, sunlight of homes"),
    QT_TRANSLATE_NOOP("Rule", "China"),
    QT_TRANSLATE_NOOP("Rule", "EN 17037, exposure to sunlight"),
    QT_TRANSLATE_NOOP("Rule", "Europe"),
    QT_TRANSLATE_NOOP("Rule", "Estonia, insolation of homes"),
    QT_TRANSLATE_NOOP("Rule", "Estonia"),
    QT_TRANSLATE_NOOP("Rule", "Four days, three hours"),
    QT_TRANSLATE_NOOP("Rule", "Philadelphia, Seattle and others"),
    QT_TRANSLATE_NOOP("Rule", "Japan, Building Standards Act, table 4"),
    QT_TRANSLATE_NOOP("Rule", "Japan"),
    QT_TRANSLATE_NOOP("Rule", "Korea, right to sunlight"),
    QT_TRANSLATE_NOOP("Rule", "Korea"),
    QT_TRANSLATE_NOOP("Rule", "Melbourne, amendment C278"),
    QT_TRANSLATE_NOOP("Rule", "Melbourne"),
    QT_TRANSLATE_NOOP("Rule", "Montreal, parks"),
    QT_TRANSLATE_NOOP("Rule", "Montreal"),
    QT_TRANSLATE_NOOP("Rule", "Montreal, east-west streets"),
    QT_TRANSLATE_NOOP("Rule", "New South Wales, Apartment Design Guide"),
    QT_TRANSLATE_NOOP("Rule", "New South Wales"),
    QT_TRANSLATE_NOOP("Rule", "A rule of your own"),
    QT_TRANSLATE_NOOP("Rule", "Anywhere"),
    QT_TRANSLATE_NOOP("Rule", "Poland, sunlight in rooms"),
    QT_TRANSLATE_NOOP("Rule", "Poland"),
    QT_TRANSLATE_NOOP("Rule", "Russia (central zone), share of territory"),
    QT_TRANSLATE_NOOP("Rule", "Russia"),
    QT_TRANSLATE_NOOP("Rule", "Russia (central zone), insolation of rooms"),
    QT_TRANSLATE_NOOP("Rule", "San Francisco, Section 295 (Proposition K)"),
    QT_TRANSLATE_NOOP("Rule", "San Francisco"),
    QT_TRANSLATE_NOOP("Rule", "The Hague, sunlight on facades"),
    QT_TRANSLATE_NOOP("Rule", "The Hague"),
    QT_TRANSLATE_NOOP("Rule", "Netherlands, TNO light"),
    QT_TRANSLATE_NOOP("Rule", "Netherlands"),
    QT_TRANSLATE_NOOP("Rule", "Netherlands, TNO strict"),
    QT_TRANSLATE_NOOP("Rule", "Toronto, shadow study"),
    QT_TRANSLATE_NOOP("Rule", "Toronto"),
    QT_TRANSLATE_NOOP("Rule", "Vancouver, parks and schoolyards"),
    QT_TRANSLATE_NOOP("Rule", "Vancouver"),
    QT_TRANSLATE_NOOP("Rule", "Zurich, shadow of tall buildings"),
    QT_TRANSLATE_NOOP("Rule", "Zurich"),
    QT_TRANSLATE_NOOP("Rule", "United States"),
    QT_TRANSLATE_NOOP("Rule", "Britain (UK)"),
    QT_TRANSLATE_NOOP("Rule", "Korea (South)"),
    QT_TRANSLATE_NOOP("Rule", "Netherlands"),
    QT_TRANSLATE_NOOP("Rule", "Russia"),
    QT_TRANSLATE_NOOP("Rule", "Switzerland"),
    QT_TRANSLATE_NOOP("Rule", "Any country"),
    QT_TRANSLATE_NOOP("Rule", "Canada"),
    QT_TRANSLATE_NOOP("Rule", "Australia")};

}  // namespace

QString scenarioName(const std::string& name) {
    return name == existingCity ? QObject::tr("Existing") : QString::fromStdString(name);
}

QString weightName(const std::string& name) {
    const QString english = QString::fromStdString(name);
    for (int month = 1; month <= 12; ++month)
        if (QLocale::c().standaloneMonthName(month) == english) return QLocale().standaloneMonthName(month);
    return translated(name);
}

QString ruleName(std::string_view name) {
    return QCoreApplication::translate("Rule", std::string(name).c_str());
}

QString nameOfTree(const Contribution& tree) {
    return QObject::tr("Tree %1", "its species or number").arg(QString::fromStdString(nameOf(tree)));
}

QString makeLink(const QString& target, const QString& text) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(target.toHtmlEscaped(), text.toHtmlEscaped());
}

}  // namespace noonmark
