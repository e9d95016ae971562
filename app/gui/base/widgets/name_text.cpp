#include "app/gui/base/widgets/name_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QObject>

#include "app/gui/base/widgets/error_text.h"
#include "core/review/library/rule_library.h"
#include "core/study/contributions/contributions.h"
#include "scenarios/scenario.h"

namespace noonmark {

QString scenarioName(const std::string& name) {
    return name == existingCity ? QObject::tr("Existing") : QString::fromStdString(name);
}

// What listUnchecked() and a review of windows add to the texts of a rule file, which all surfaces look for
// among those.
[[maybe_unused]] static constexpr const char* uncheckedTexts[] = {
    QT_TRANSLATE_NOOP("Rule", "Slopes: there is no terrain, so the ground is taken as flat"),
    QT_TRANSLATE_NOOP("Rule", "The rule leaves terrain out; here terrain casts shadow"),
    QT_TRANSLATE_NOOP("Rule",
                      "Where the windows are: one was assumed in each bay and storey of the facades")};

// Not by whatever context has the same word: a rule of the user's own may be called "Tower".
QString ruleName(std::string_view name) {
    if (name == anyCountry) return translated(name);
    return QCoreApplication::translate("Rule", std::string(name).c_str());
}

QString weightName(const std::string& name) {
    const QString english = QString::fromStdString(name);
    for (int month = 1; month <= 12; ++month)
        if (QLocale::c().standaloneMonthName(month) == english) return QLocale().standaloneMonthName(month);
    return QCoreApplication::translate("noonmark", name.c_str());
}

QString nameOfTree(const Contribution& tree) {
    return QObject::tr("Tree %1", "its species or number").arg(QString::fromStdString(nameOf(tree)));
}

QString makeLink(const QString& target, const QString& text) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(target.toHtmlEscaped(), text.toHtmlEscaped());
}

}  // namespace noonmark
