#include <gtest/gtest.h>

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QDBusVirtualObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>

#include "app/gui/base/looks/theme_source.h"
#include "tests/gui/wait_for.h"

namespace noonmark {

namespace {

using test::waitFor;

const QString path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString settings = QStringLiteral("org.freedesktop.portal.Settings");

/// The desktop portal's settings, with one setting.
class FakePortal final : public QDBusVirtualObject {
public:
    explicit FakePortal(QDBusConnection bus) : bus_(std::move(bus)) {}

    uint scheme = 0;

    [[nodiscard]] QString introspect(const QString&) const override { return {}; }

    // The portal wraps the value in two variants here, and in one in the signal.
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& bus) override {
        const QVariantList asked{QStringLiteral("org.freedesktop.appearance"),
                                 QStringLiteral("color-scheme")};
        if (message.member() != QStringLiteral("Read") || message.arguments() != asked) return false;
        const QDBusVariant inner(scheme);
        return bus.send(message.createReply(QVariant::fromValue(QDBusVariant(QVariant::fromValue(inner)))));
    }

    void change(const char* group, const char* key, uint value) {
        QDBusMessage signal = QDBusMessage::createSignal(path, settings, QStringLiteral("SettingChanged"));
        signal << QString::fromLatin1(group) << QString::fromLatin1(key)
               << QVariant::fromValue(QDBusVariant(value));
        bus_.send(signal);
    }

private:
    QDBusConnection bus_;
};

/// A bus of the test's own.
struct PortalTheme : ::testing::Test {
    QProcess daemon;
    QString address;

    void SetUp() override {
        const QString program = QStandardPaths::findExecutable(QStringLiteral("dbus-daemon"));
        if (program.isEmpty()) GTEST_SKIP() << "there is no dbus-daemon";
        daemon.start(program, {QStringLiteral("--session"), QStringLiteral("--nofork"),
                               QStringLiteral("--print-address")});
        ASSERT_TRUE(waitFor([this] { return daemon.canReadLine(); }));
        address = QString::fromLatin1(daemon.readLine().trimmed());
    }
    void TearDown() override {
        daemon.kill();
        daemon.waitForFinished();
    }
};

TEST_F(PortalTheme, IsReadAndFollowed) {
    QDBusConnection bus = QDBusConnection::connectToBus(address, QStringLiteral("fake portal"));
    FakePortal portal(bus);
    portal.scheme = 1;
    ASSERT_TRUE(bus.registerService(QStringLiteral("org.freedesktop.portal.Desktop")));
    ASSERT_TRUE(bus.registerVirtualObject(path, &portal));
    const auto source = makePortalThemeSource(address);
    ASSERT_NE(source, nullptr);
    EXPECT_EQ(source->theme(), std::nullopt) << "not answered yet";
    EXPECT_TRUE(waitFor([&] { return source->theme() == Theme::dark; }));
    portal.change("org.gnome.desktop.interface", "color-scheme", 2);
    portal.change("org.freedesktop.appearance", "accent-color", 2);
    portal.change("org.freedesktop.appearance", "color-scheme", 2);
    EXPECT_TRUE(waitFor([&] { return source->theme() != Theme::dark; }));
    EXPECT_EQ(source->theme(), Theme::light);
    portal.change("org.freedesktop.appearance", "color-scheme", 0);
    EXPECT_TRUE(waitFor([&] { return !source->theme(); }));
    QDBusConnection::disconnectFromBus(QStringLiteral("fake portal"));
}

TEST_F(PortalTheme, IsUnknownWhereNoPortalRuns) {
    const auto source = makePortalThemeSource(address);
    ASSERT_NE(source, nullptr);
    int told = 0;
    QObject::connect(source.get(), &ThemeSource::changed, source.get(), [&told] { ++told; });
    QTimer timer;
    timer.setSingleShot(true);
    timer.start(300);
    ASSERT_TRUE(waitFor([&] { return !timer.isActive(); }));
    EXPECT_EQ(source->theme(), std::nullopt);
    EXPECT_EQ(told, 0);
}

TEST(PortalThemes, ABusThatIsNotThereGivesNoSource) {
    EXPECT_EQ(makePortalThemeSource(QStringLiteral("unix:path=/nowhere/bus")), nullptr);
}

}  // namespace
}  // namespace noonmark
