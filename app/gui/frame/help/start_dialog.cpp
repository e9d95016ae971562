#include "app/gui/frame/help/start_dialog.h"

#include <QCommandLinkButton>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/looks/icons.h"
#include "app/gui/frame/tour/tour_actions.h"

namespace noonmark {

namespace {

constexpr int iconPx = 24;
constexpr qsizetype maxRecent = 5;

QLabel* makeHeading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    label->setContentsMargins(0, 8, 0, 0);
    return label;
}

}  // namespace

StartDialog::StartDialog(const RecentFiles& recent, QWidget* parent) : QDialog(parent) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Start"));
    auto* column = new QVBoxLayout(this);
    column->setSpacing(2);
    column->addWidget(new QLabel(tr("Noonmark measures the shadows that buildings cast on a city.")));
    addEntry(*column, QStringLiteral("open"), tr("Open a city or a project..."),
             tr("Footprints, OpenStreetMap, CityJSON, meshes, terrain"), "startOpen",
             [this] { Q_EMIT openRequested(); });
    addRecent(*column, recent);
    addSamples(*column);
    addTours(*column);
    column->addWidget(makeHeading(tr("Help")));
    addEntry(*column, QStringLiteral("help"), tr("User guide"), tr("How to study, compare and review"),
             "startGuide", [this] { Q_EMIT guideRequested(); });
    column->addStretch(1);
    setMinimumWidth(460);
}

void StartDialog::addSamples(QVBoxLayout& column) {
    column.addWidget(makeHeading(tr("Samples")));
    addEntry(column, QStringLiteral("place"), tr("Central Park South"),
             tr("The park, its streets and the towers of the case study"), "startPark",
             [this] { Q_EMIT chosen({QStringLiteral("sample:central-park-south")}, {}); });
    addEntry(column, QStringLiteral("analyse"), tr("Grid"), tr("A synthetic city of blocks and lots"),
             "startGrid", [this] { Q_EMIT chosen({QStringLiteral("sample:grid")}, {}); });
}

void StartDialog::addTours(QVBoxLayout& column) {
    column.addWidget(makeHeading(tr("Guided tours")));
    const char* const icons[] = {"tower", "analyse", "review"};
    const auto tours = listTours();
    for (std::size_t i = 0; i < tours.size(); ++i)
        addEntry(column, QString::fromLatin1(icons[i]), titleOf(tours[i]), aboutOf(tours[i]), "startTour",
                 [this, i] { Q_EMIT tourRequested(i); });
}

void StartDialog::addRecent(QVBoxLayout& column, const RecentFiles& recent) {
    const QStringList entries = recent.entries().mid(0, maxRecent);
    if (entries.isEmpty()) return;
    column.addWidget(makeHeading(tr("Recent")));
    for (const QString& entry : entries) {
        const QStringList files = RecentFiles::filesOf(entry);
        addEntry(column, QStringLiteral("sheets"), RecentFiles::nameOf(entry),
                 fontMetrics().elidedText(files.first(), Qt::ElideMiddle, 380), "startRecent",
                 [this, files, reading = recent.readingOf(entry)] { Q_EMIT chosen(files, reading); });
    }
}

void StartDialog::addEntry(QVBoxLayout& column, const QString& icon, const QString& title,
                           const QString& text, const char* name, const std::function<void()>& done) {
    auto* button = new QCommandLinkButton(title, text);
    button->setObjectName(QString::fromLatin1(name));
    button->setIcon(makeIcon(icon));
    button->setIconSize({iconPx, iconPx});
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, done] {
        done();
        close();
    });
    column.addWidget(button);
}

}  // namespace noonmark
