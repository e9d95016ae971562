#include "app/gui/view/compare/compare_strip.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "app/gui/session/project/project_session.h"

namespace noonmark {

CompareStrip::CompareStrip(ProjectSession& session, QWidget* parent)
    : QWidget(parent), session_(session), other_(new QComboBox), note_(new QLabel), displayed_(new QLabel) {
    setObjectName(QStringLiteral("compareStrip"));
    other_->setObjectName(QStringLiteral("compareOther"));
    other_->setToolTip(tr("The scenario on the left, or under the key C"));
    other_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    displayed_->setToolTip(tr("The displayed scenario, which edits change"));
    note_->setObjectName(QStringLiteral("compareNote"));
    note_->setAlignment(Qt::AlignCenter);
    auto* close = new QToolButton;
    close->setText(QStringLiteral("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Ends the comparison in the view"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 4, 2);
    row->addWidget(other_);
    row->addWidget(note_, 1);
    row->addWidget(displayed_);
    row->addWidget(close);
    connect(other_, &QComboBox::activated, this,
            [this] { Q_EMIT otherChosen(other_->currentText().toStdString()); });
    connect(close, &QToolButton::clicked, this, &CompareStrip::closed);
    connect(&session_, &ProjectSession::changed, this, &CompareStrip::fill);
    fill();
}

void CompareStrip::fill() {
    const QString before = other_->currentText();
    const QSignalBlocker block(other_);
    other_->clear();
    for (const std::string& name : listOthers(session_)) other_->addItem(QString::fromStdString(name));
    other_->setCurrentText(before);
    displayed_->setText(QString::fromStdString(session_.scenario()));
}

void CompareStrip::setOther(const std::string& scenario) {
    const QSignalBlocker block(other_);
    other_->setCurrentText(QString::fromStdString(scenario));
}

void CompareStrip::setNote(const QString& note) { note_->setText(note); }

std::vector<std::string> listOthers(const ProjectSession& session) {
    std::vector<std::string> names;
    if (session.scenario() != existingCity) names.emplace_back(existingCity);
    for (const Scenario& scenario : session.project().scenarios)
        if (scenario.name != session.scenario()) names.push_back(scenario.name);
    return names;
}

}  // namespace noonmark
