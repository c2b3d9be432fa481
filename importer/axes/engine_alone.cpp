// SPDX-License-Identifier: GPL-3.0-or-later
// The text engine's libraries refer to functions of other libraries that it never calls here: fetching a web
// page, unpacking models, writing animations. These replacements make it unnecessary to load some 40 shared
// libraries (TLS, Kerberos, LDAP, XML, ICU, ...; docs/develop/decisions/0406-text-engine.md). Each returns an
// error that the replaced function may return; the engine then continues without it.

extern "C" {

// libarchive: -30 is its fatal error.
void* archive_read_new() { return nullptr; }
int archive_read_support_filter_all(void*) { return -30; }
int archive_read_support_format_all(void*) { return -30; }
int archive_read_open_filename(void*, const char*, unsigned long) { return -30; }
int archive_read_next_header(void*, void**) { return -30; }
long archive_read_data(void*, void*, unsigned long) { return -30; }
int archive_read_free(void*) { return 0; }
const char* archive_entry_pathname(void*) { return nullptr; }
long archive_entry_size(void*) { return 0; }

// libcurl: 2 is "failed to start".
void* curl_easy_init() { return nullptr; }
int curl_easy_setopt(void*, int, ...) { return 2; }
int curl_easy_perform(void*) { return 2; }
const char* curl_easy_strerror(int) { return "not built in"; }
void curl_easy_cleanup(void*) {}

// Leptonica's gifio.c and webpanimio.c: null means no picture, 1 means failure.
void* pixReadStreamGif(void*) { return nullptr; }
void* pixReadMemGif(const unsigned char*, unsigned long) { return nullptr; }
int pixWriteStreamGif(void*, void*) { return 1; }
int pixWriteMemGif(unsigned char**, unsigned long*, void*) { return 1; }
int pixaWriteWebPAnim(const char*, void*, int, int, int, int) { return 1; }
int pixaWriteStreamWebPAnim(void*, void*, int, int, int, int) { return 1; }
int pixaWriteMemWebPAnim(unsigned char**, unsigned long*, void*, int, int, int, int) { return 1; }
}
