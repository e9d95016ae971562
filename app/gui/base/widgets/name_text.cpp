#include "app/gui/base/widgets/name_text.h"

#include <QLocale>
#include <QObject>

#include "app/gui/base/widgets/error_text.h"
#include "core/study/contributions/contributions.h"
#include "scenarios/scenario.h"

namespace noonmark {

QString scenarioName(const std::string& name) {
    return name == existingCity ? QObject::tr("Existing") : QString::fromStdString(name);
}

QString ruleName(std::string_view name) { return translated(name); }

QString weightName(const std::string& name) {
    const QString english = QString::fromStdString(name);
    for (int month = 1; month <= 12; ++month)
        if (QLocale::c().standaloneMonthName(month) == english) return QLocale().standaloneMonthName(month);
    return translated(name);
}

QString nameOfTree(const Contribution& tree) {
    return QObject::tr("Tree %1", "its species or number").arg(QString::fromStdString(nameOf(tree)));
}

QString makeLink(const QString& target, const QString& text) {
    return QStringLiteral("<a href=\"%1\">%2</a>").arg(target.toHtmlEscaped(), text.toHtmlEscaped());
}

}  // namespace noonmark
