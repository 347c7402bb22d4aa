/* What XML 1.0 calls well formed, production by production, and what it does not. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "text/xml.h"

static const char *const GOOD[] = {
    "<a/>",
    "<a></a>",
    "<a ></a >",
    "\xEF\xBB\xBF<?xml version=\"1.0\"?><a/>",
    "<?xml version='1.1' encoding='UTF-8' standalone='yes' ?>\n<a/>\n",
    "<!-- - - --><?p?><?p x?y ?><a/><!----><?q ? ?>",
    "<a b='1' c = \"2>'\" d=''/>",
    "<a><b/>x &lt;&gt;&amp;&quot;&apos;&#65;&#x10FFFF; ]] > <b>]</b></a>",
    "<a><![CDATA[<b>&]] >]]></a>",
    "<\xC3\xA9:x-1.2/>",
    "<!DOCTYPE a><a/>",
    "<!DOCTYPE a SYSTEM 'x' ><a/>",
    "<!DOCTYPE a PUBLIC '-//x' \"y\" [ <!ENTITY e 'x'> <!ENTITY f '&e;&#38;'> <!ENTITY % p SYSTEM 'u'> %p;"
    "<!ELEMENT a (#PCDATA|b)*><!ATTLIST a b CDATA '>'><!NOTATION n PUBLIC 'x'><!ENTITY u SYSTEM 'x' NDATA n>"
    "<!-- > --><?p > ?>] ><a b='&f;'>&e;</a>",
    "<!DOCTYPE a [<!ENTITY z 'x'><!ENTITY b '&z;'>]><a>&b;</a>",
};
static const char *const BAD[] = {
    "",
    " ",
    "a",
    "<a>",
    "</a>",
    "<a></b>",
    "<a><b></a></b>",
    "<a/><b/>",
    "<a/>x",
    "x<a/>",
    "<a/",
    "<a",
    "<1/>",
    "< a/>",
    "<a b/>",
    "<a b=1/>",
    "<a b='1/>",
    "<a b='<'/>",
    "<a b='1'c='2'/>",
    "<a b='1' c='2' b='3'/>",
    "<a / >",
    "<a>&</a>",
    "<a>&x;</a>",
    "<a>&lt</a>",
    "<a>&#0;</a>",
    "<a>&#x1F;</a>",
    "<a>&#xD800;</a>",
    "<a>&#x110000;</a>",
    "<a>&#99999999999;</a>",
    "<a>&#;</a>",
    "<a>&#x;</a>",
    "<a>&#X41;</a>",
    "<a>]]></a>",
    "<a b='&x;'/>",
    "<a>\x01</a>",
    "<a>\xC0\x80</a>",
    "<a>\xEF\xBF\xBF</a>",
    "<a>\xED\xA0\x80</a>",
    "<a><!-- -- --></a>",
    "<a><!-- --->x</a>",
    "<a><!-- </a>",
    "<a><![CDATA[</a>",
    "<a><?xml x?></a>",
    "<a><?p</a>",
    "<a><? p?></a>",
    " <?xml version='1.0'?><a/>",
    "<?xml?><a/>",
    "<?xml version='2.0'?><a/>",
    "<?xml encoding='x'?><a/>",
    "<?xml version='1.0' standalone='x'?><a/>",
    "<?xml version='1.0' encoding='8'?><a/>",
    "<?xml version='1.0'><a/>",
    "<!DOCTYPE><a/>",
    "<!DOCTYPE a [<a/>",
    "<!DOCTYPE a [<!ENTITY e 'x]><a/>",
    "<!DOCTYPE a [<!ENTITY e>]><a/>",
    "<!DOCTYPE a [x]><a/>",
    "<a/><!DOCTYPE a>",
    "<!DOCTYPE a><!DOCTYPE a><a/>",
    "<!DOCTYPE a [<!ELEMENT>]><a/>",
    "<!DOCTYPE a [<!ENTITY e '&e;'>]><a/>",
    "<!DOCTYPE a [<!ENTITY e '&f;'><!ENTITY f '&e;'>]><a/>",
    "<!DOCTYPE a [<!ENTITY e SYSTEM 'x'>]><a>&e;</a>",
    "<!DOCTYPE a [<!ATTLIST a b CDATA '>]><a/>",
    "<![CDATA[x]]>",
    "<a>&#38</a>",
    "<a><b c='&#1;'/></a>",
    "<a></a b='1'>",
    "<a></>",
    "<>",
    "<a><!></a>",
};

static void each_production(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof GOOD / sizeof *GOOD; i++)
        if (bat_xml_check(GOOD[i], strlen(GOOD[i])) != BAT_OK) fail_msg("%s", GOOD[i]);
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++)
        if (bat_xml_check(BAD[i], strlen(BAD[i])) != BAT_SYNTAX) fail_msg("%s", BAD[i]);
    assert_int_equal(bat_xml_check("<a>\0</a>", 8), BAT_SYNTAX);
}

static void failing_allocations(void **state) {
    (void)state;
    static const char text[] = "<!DOCTYPE a [<!ENTITY e 'x'>]><a b='1' c='2'><d/>&e;</a>";
    const long live = alloc_live();
    for (int n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_xml_check(text, strlen(text));
        assert_int_equal(alloc_live(), live);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            return;
        }
        assert_int_equal(status, BAT_MEMORY);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_production),
                                       cmocka_unit_test(failing_allocations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
