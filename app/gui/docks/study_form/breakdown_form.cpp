#include "app/gui/docks/study_form/breakdown_form.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/widgets/translated.h"
#include "app/input/all_engines.h"
#include "core/study/contributions/contributions.h"
#include "core/study/text/breakdown_text.h"

namespace noonmark {

namespace {

using Ability = bool EngineCapabilities::*;

QCheckBox* makeBox(const QString& text, const char* name, const QString& tip) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QString::fromLatin1(name));
    box->setToolTip(tip);
    return box;
}

// Core's engines only: looking for a graphics device takes a moment, and its engines sum neither.
QString listEnginesWith(Ability ability) {
    QStringList names;
    for (const EngineEntry& engine : coreEngines())
        if (engine.info.capabilities.*ability) names << translated(engine.info.name);
    return names.join(QObject::tr(", "));
}

bool isAble(const StudySettings& settings, Ability ability) {
    const EngineEntry* engine = findEngine(enginesWith(settings.engine), settings.engine);
    return engine != nullptr && engine->info.capabilities.*ability;
}

QString define(const QString& what, std::string_view definition) {
    return what + QStringLiteral(": ") + translated(definition);
}

}  // namespace

QString whyNoMonths(const StudySettings& settings) {
    if (isAble(settings, &EngineCapabilities::sets)) return {};
    return QObject::tr("This method does not sum months. These do: %1.")
        .arg(listEnginesWith(&EngineCapabilities::sets));
}

QString whyNoContributions(const StudySettings& settings) {
    if (isAble(settings, &EngineCapabilities::attribution)) return {};
    return QObject::tr("This method does not tell buildings apart. These do: %1.")
        .arg(listEnginesWith(&EngineCapabilities::attribution));
}

BreakdownForm::BreakdownForm(QWidget* parent)
    : QWidget(parent),
      months_(makeBox(tr("Each month by itself"), "byMonth",
                      tr("Also sums the shadow of each month: bars in the dock Contributions, a table and "
                         "maps in exports"))),
      contributions_(
          makeBox(tr("Contribution of each building"), "byBuilding",
                  tr("Also finds what each building takes, for the dock Contributions and exports; "
                     "takes up to twice as long.") +
                      QLatin1Char('\n') + define(tr("Attributed shadow"), attributedDefinition()) +
                      QLatin1Char('\n') + define(tr("Sole contribution"), soleDefinition()))),
      why_(new QLabel) {
    why_->setObjectName(QStringLiteral("whyNoBreakdown"));
    why_->setWordWrap(true);
    why_->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{months_, contributions_, why_})
        column->addWidget(widget);
    connect(months_, &QCheckBox::toggled, this, [this](bool on) {
        settings_.byMonth = on;
        Q_EMIT edited(settings_, tr("months"));
    });
    connect(contributions_, &QCheckBox::toggled, this, [this](bool on) {
        settings_.contributions = on;
        Q_EMIT edited(settings_, tr("contributions"));
    });
    enable();
}

void BreakdownForm::show(const StudySettings& settings) {
    settings_ = settings;
    const QSignalBlocker quietMonths(months_), quietContributions(contributions_);
    months_->setChecked(settings.byMonth);
    contributions_->setChecked(settings.contributions);
    enable();
}

void BreakdownForm::setOfCells(bool ofCells) {
    ofCells_ = ofCells;
    enable();
}

// A box that is ticked can be unticked whatever the engine.
void BreakdownForm::enable() {
    setVisible(ofCells_);
    const QString noMonths = whyNoMonths(settings_), noContributions = whyNoContributions(settings_);
    months_->setEnabled(noMonths.isEmpty() || settings_.byMonth);
    contributions_->setEnabled(noContributions.isEmpty() || settings_.contributions);
    why_->setText(noMonths.isEmpty() ? noContributions : noMonths);
    why_->setVisible(!why_->text().isEmpty());
}

}  // namespace noonmark
