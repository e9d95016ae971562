#include "app/gui/session/study/open_options.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/widgets/reading_form.h"

namespace noonmark {

namespace {

constexpr qsizetype maxNames = 6;

QString namesOf(const QStringList& files) {
    QStringList names;
    for (const QString& file : files.first(std::min(files.size(), maxNames)))
        names << QFileInfo(file).fileName();
    if (files.size() > maxNames) names << QObject::tr("and %1 more").arg(files.size() - maxNames);
    return names.join(QLatin1Char('\n'));
}

}  // namespace

OpenOptions::OpenOptions(QWidget* parent) : QDialog(parent), names_(new QLabel), form_(new ReadingForm) {
    setObjectName(QStringLiteral("openOptions"));
    setWindowTitle(tr("Open with options"));
    names_->setObjectName(QStringLiteral("files"));
    names_->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setToolTip(tr("Read the files with these settings"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(names_);
    column->addWidget(form_);
    column->addWidget(buttons);
    column->setSizeConstraint(QLayout::SetMinimumSize);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, [this] { Q_EMIT chosen(files_, form_->settings()); });
}

void OpenOptions::ask(const QStringList& files, const ReadSettings& settings) {
    files_ = files;
    names_->setText(namesOf(files));
    names_->setToolTip(files.join(QLatin1Char('\n')));
    form_->show(settings);
    show();
    raise();
    activateWindow();
}

void OpenOptions::setMiddle(std::optional<LonLat> middle) { form_->setMiddle(middle); }

}  // namespace noonmark
