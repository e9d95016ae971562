#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>

#include "app/gui/frame/help/about_text.h"
#include "app/gui/frame/help/guide_window.h"
#include "core/simd/instruction_set.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

/// The links and pictures of a page in Markdown, without those to the network and to places in the page.
QStringList linksOf(const QString& page) {
    QFile file(QStringLiteral(":/guide/user/%1.md").arg(page));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << page.toStdString();
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+)(#[^)]*)?\\)"));
    QStringList links;
    for (auto found = link.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();) {
        const QString target = found.next().captured(1);
        if (!target.startsWith(QStringLiteral("http"))) links << target;
    }
    return links;
}

TEST(Guide, IsInTheProgramWithItsPicturesAndTheOtherPages) {
    const QList<GuidePage> pages = listGuidePages();
    EXPECT_GE(pages.size(), 10);
    for (const GuidePage& page : pages) {
        EXPECT_NE(page.title, page.name) << "the page is missing";
        for (const QString& link : linksOf(page.name)) {
            if (!link.endsWith(QStringLiteral(".png"))) continue;
            const QString file = QUrl(QStringLiteral("qrc:/guide/user/")).resolved(QUrl(link)).path();
            EXPECT_TRUE(QFile::exists(QLatin1Char(':') + file))
                << page.name.toStdString() << ": " << link.toStdString();
        }
    }
}

TEST_F(ProjectWindow, F1OpensTheGuideAndALinkTurnsItsPage) {
    window->help().guide()->trigger();
    auto* guide = window->findChild<GuideWindow*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_EQ(guide->page(), QStringLiteral("window"));
    EXPECT_TRUE(guide->text().toPlainText().contains(QStringLiteral("Changing buildings")));
    Q_EMIT guide->text().anchorClicked(QUrl(QStringLiteral("places.md")));
    EXPECT_EQ(guide->page(), QStringLiteral("places"));
    EXPECT_EQ(&window->help().showGuide({QStringLiteral("review"), {}}), guide) << "one guide, not a second";
}

TEST_F(ProjectWindow, AboutNamesTheVersionAndTheInstructionSet) {
    const std::string text = makeAboutText().toStdString();
    EXPECT_THAT(text, testing::HasSubstr("Noonmark"));
    EXPECT_THAT(text, testing::HasSubstr(std::string(nameOf(instructionSetInUse()))));
    window->help().about()->trigger();
    EXPECT_NE(window->findChild<QMessageBox*>(QStringLiteral("about")), nullptr);
}

}  // namespace
}  // namespace noonmark
