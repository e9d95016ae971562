#include "app/gui/base/looks/theme_source.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QFileInfo>

namespace noonmark {

namespace {

const QString portal = QStringLiteral("org.freedesktop.portal.Desktop");
const QString portalPath = QStringLiteral("/org/freedesktop/portal/desktop");
const QString portalSettings = QStringLiteral("org.freedesktop.portal.Settings");
const QString appearance = QStringLiteral("org.freedesktop.appearance");
const QString colourScheme = QStringLiteral("color-scheme");

/// 1: dark, 2: light, anything else: no preference. The portal wraps the number in one variant or in two.
std::optional<Theme> themeFrom(QVariant value) {
    while (value.canConvert<QDBusVariant>()) value = value.value<QDBusVariant>().variant();
    switch (value.toUInt()) {
        case 1:
            return Theme::dark;
        case 2:
            return Theme::light;
        default:
            return std::nullopt;
    }
}

class PortalThemeSource final : public ThemeSource {
    Q_OBJECT
public:
    explicit PortalThemeSource(QDBusConnection bus) : bus_(std::move(bus)) {
        qRegisterMetaType<QDBusVariant>();  // else Qt does not find the slot by its arguments
        // From any sender: the portal may start later, or again.
        bus_.connect(QString(), portalPath, portalSettings, QStringLiteral("SettingChanged"), this,
                     SLOT(take(QString, QString, QDBusVariant)));
        QDBusMessage question =
            QDBusMessage::createMethodCall(portal, portalPath, portalSettings, QStringLiteral("Read"));
        question << appearance << colourScheme;
        auto* answer = new QDBusPendingCallWatcher(bus_.asyncCall(question), this);
        connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
            const QDBusPendingReply<QDBusVariant> reply = *answer;
            if (reply.isValid()) take(appearance, colourScheme, reply.value());
            answer->deleteLater();
        });
    }

    [[nodiscard]] std::optional<Theme> theme() const override { return theme_; }

private Q_SLOTS:
    void take(const QString& group, const QString& key, const QDBusVariant& value) {
        if (group != appearance || key != colourScheme) return;
        theme_ = themeFrom(value.variant());
        Q_EMIT changed();
    }

private:
    QDBusConnection bus_;
    std::optional<Theme> theme_;
};

// Asking for the session bus where none runs would start one.
bool hasSessionBus() {
    const QString runtime = qEnvironmentVariable("XDG_RUNTIME_DIR");
    return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
           (!runtime.isEmpty() && QFileInfo::exists(runtime + QStringLiteral("/bus")));
}

std::unique_ptr<ThemeSource> makeSource(const QDBusConnection& bus) {
    if (!bus.isConnected()) return nullptr;
    return std::make_unique<PortalThemeSource>(bus);
}

}  // namespace

std::unique_ptr<ThemeSource> makePortalThemeSource() {
    return hasSessionBus() ? makeSource(QDBusConnection::sessionBus()) : nullptr;
}

std::unique_ptr<ThemeSource> makePortalThemeSource(const QString& busAddress) {
    return makeSource(QDBusConnection::connectToBus(busAddress, busAddress));
}

}  // namespace noonmark

#include "theme_source_dbus.moc"
