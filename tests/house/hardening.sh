# Debian's hardening flags and similar ones, without the one that knows the folder: CFLAGS and LDFLAGS of the environment.
DEB_BUILD_MAINT_OPTIONS=reproducible=-fixfilepath,-fixdebugpath
export DEB_BUILD_MAINT_OPTIONS
CFLAGS="$(dpkg-buildflags --get CFLAGS) $(dpkg-buildflags --get CPPFLAGS) -fstack-clash-protection -fcf-protection"
LDFLAGS="$(dpkg-buildflags --get LDFLAGS) -Wl,-z,now"
export CFLAGS LDFLAGS
