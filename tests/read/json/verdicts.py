"""Verdicts on JSON of the kinds that JSONTestSuite has: what the grammar of RFC 8259 accepts is read, the rest is refused.

usage: verdicts.py TCBSAMPLE

Each value of the table stands deep in a member of a key that has no meaning, in an input of each shape. Then there are
whole inputs. What RFC 8259 leaves open has the verdict that the manual documents or that follows from UTF-8,
or from a byte order mark.
"""
import subprocess
import sys
import tempfile

program = sys.argv[1]

accepted_values = [
    b"0", b"-0", b"1", b"-1", b"123", b"0.5", b"-0.5", b"1.25", b"0e0", b"0e1", b"0e+1", b"0E-1", b"1e5", b"1E5",
    b"1e+5", b"1e-5", b"1E+2", b"1.5e2", b"1.5E-2", b"-1e-2", b"-0.0", b"1e-400", b"-1e-400", b"0e999999999999",
    b"0.0e400", b"1e-999999999999", b"123456789012345678901234567890", b"-123456789012345678901234567890",
    b"18446744073709551615", b"18446744073709551616", b"9223372036854775807", b"-9223372036854775808",
    b"-9223372036854775809", b"0." + b"0" * 400 + b"1", b"1" * 300, b"0.1234567890123456789012345678901234567890",
    b"1.7976931348623157e308", b"4.9e-324", b"2.2250738585072011e-308",
    b"true", b"false", b"null", b'""', b'" "', b'"a"', b'"\\""', b'"\\\\"', b'"\\/"', b'"/"', b'"\\b\\f\\n\\r\\t"',
    b'"\\u0041"', b'"\\u00e9"', b'"\\u20AC"', b'"\\u20ac"', b'"\\u0000"', b'"\\u0022"', b'"\\u005C"', b'"\\u002c\\u005b"',
    b'"\\uD83D\\uDE00"', b'"\\ud800\\udc00"', b'"\\uDBFF\\uDFFF"', b'"\\uFFFF"', b'"\\uFFFE"', b'"\\uFDD0"',
    b'"\\u2028\\u2029"', b'"\\u200B"', b'"\xc3\xa9"', b'"\xe2\x82\xac"', b'"\xf0\x9f\x98\x80"', b'"\xef\xbf\xbf"',
    b'"\xf4\x8f\xbf\xbf"', b'"\xe2\x80\xa8"', b'"\xef\xbb\xbf"', b'"\x7f"', b'"\xc2\x80"', b'"[{]},:"', b'"a/*b*/c"',
    b'"#"', b'"\\\\a"', b'"\\\\\\""', b'"\\\\n"', b'"a\xcc\x88"',
    b"[]", b"[ ]", b"[\t]", b"[[]]", b"[[],[]]", b"[1,2]", b"[ 1 , 2 ]", b"[1,null,\"a\",true]", b'["a",[1,{"b":[]}]]',
    b"{}", b"{ }", b'{"a":1}', b'{ "a" : 1 }', b'{"a":1,"b":2}', b'{"":0}', b'{"a":{}}', b'{"a":[]}', b'{"a":1,"a":2}',
    b'{"a":1,"a":1}', b'{"\\u0061":1}', b'{"\\"":1}', b'{"[":"]"}', b'{"keys":[]}', b'{"curves":[{}]}', b'{"a\\\\":1}',
    b"[" * 90 + b"]" * 90, b'{"a":' * 90 + b"1" + b"}" * 90, b'[{"a":' * 45 + b"[]" + b"}]" * 45, b"NaN", b"[NaN,1]",
]

refused_values = [
    b",", b":", b"-", b"+1", b"+", b".5", b"-.5", b"1.", b"-1.", b"1.e1", b"0.e1", b".", b"1e", b"1E", b"1e+", b"1e-",
    b"1.5e", b"1.5e+", b"e5", b"1ee5", b"1e5.5", b"1.5.5", b"01", b"-01", b"00", b"-00", b"012", b"01.5", b"0x1", b"0x",
    b"1x", b"1_000", b"1,000,", b"- 1", b"--1", b"-+1", b"1-1", b"1+1", b"1 2", b"1 000", b"0b1", b"1f", b"1.5f", b"1L",
    b"nan", b"-NaN", b"NaN1", b"NaN.5", b"Infinity", b"-Infinity", b"+Infinity", b"Inf", b"inf", b"-inf", b"-a", b"1e400", b"-1e400",
    b"1" * 400, b"1e99999999999", b"1.7976931348623159e308", b"\xef\xbc\x91",
    b"True", b"False", b"Null", b"TRUE", b"nul", b"nulll", b"tru", b"truee", b"fals", b"falsee", b"true false", b"None",
    b"undefined", b"yes", b"a", b"'a'", b"''", b"`a`", b"\xc3\xa9", b"*", b"@", b"$", b"\\u0061", b"\\n", b'\\"a"', b"#",
    b'"', b'"a', b'a"', b'"a" "b"', b'"a""b"', b'"\\"', b'"\\x41"', b'"\\a"', b'"\\0"', b'"\\\'"', b'"\\v"', b'"\\e"',
    b'"\\U0041"', b'"\\u"', b'"\\u0"', b'"\\u00"', b'"\\u004"', b'"\\u004G"', b'"\\u{41}"', b'"\\uqqqq"', b'"\\u 041"',
    b'"\\ "', b'"\\\xc3\xa9"', b'"\t"', b'"\x01"', b'"\x1f"', b'"\x0b"', b'"\x0c"', b'"\r"', b'"a\x08"',
    b'"\\uD800"', b'"\\uDC00"', b'"\\uD800\\u0041"', b'"\\uD800a"', b'"\\uD800\\n"', b'"\\uD800\\uD800"',
    b'"\\uDC00\\uD800"', b'"\\uDFFF"', b'{"\\uD800":1}',
    b'"\\uD83D\\u"', b'"\\uD83D\\uDE0"', b'"\\uD83D\\"',
    b'"\xff"', b'"\xfe"', b'"\xc3"', b'"\x80"', b'"\xbf"', b'"\xc0\x80"', b'"\xc1\xbf"', b'"\xe0\x80\x80"',
    b'"\xe2\x82"', b'"\xed\xa0\x80"', b'"\xed\xbf\xbf"', b'"\xf0\x80\x80\x80"', b'"\xf0\x9f\x98"', b'"\xf4\x90\x80\x80"',
    b'"\xf5\x80\x80\x80"', b'"\xf8\x88\x80\x80\x80"', b'"\xc3\x28"', b'"\xe9"',
    b"[", b"]", b"[1", b"[1,", b"[1,]", b"[,1]", b"[,]", b"[1,,2]", b"[1 2]", b"[1:2]", b"[1;2]", b"[1}", b"[]]", b"[[]",
    b"[1]2", b'["a":1]', b"[*]", b"[1,\x00]", b"[//\n]", b"[/**/]", b"[1 /*a*/]", b"[#\n]", b"[\x0c]", b"[\x0b]",
    b"[\xc2\xa0]", b"[\xe2\x81\xa0]", b"[\xef\xbb\xbf]", b"[1\xc2\xa0]", b"(1)", b"<1>",
    b"{", b"}", b'{"a"', b'{"a":', b'{"a":1', b'{"a":1,', b'{"a":1,}', b'{,"a":1}', b'{"a":1,,"b":2}', b"{,}", b'{"a"}',
    b'{"a",1}', b'{"a" 1}', b'{"a"::1}', b'{"a"=1}', b'{"a":}', b'{:1}', b"{a:1}", b"{'a':1}", b"{1:1}", b"{1}", b'{"a"}',
    b"{null:1}", b"{true:1}", b"{[]:1}", b"{{}:1}", b'{"a":1 "b":2}', b'{"a":1;"b":2}', b'{"a":1]', b'{"a":1}}',
    b'{"a":"b}', b'{"a:1}', b'{"a":1:2}', b'{"a":1,"b"}', b'{"a":1,"b":}', b'{"a\t":1}', b'{"\xff":1}',
    b'{"\\x":1}', b'{"a":1}/**/', b'{"a":1}#', b'{"a":1,"b":2,}', b'{"a":[1,{"b":[2,}]}', b"[" * 500, b"]" * 3,
    b"[" * 500 + b"]" * 500, b"[" * 101 + b"]" * 101, b"[" * 500 + b"]" * 499, b"[" * 499 + b"]" * 500, b'{"a":' * 300, b"[{" * 100,
]

key = b'{"t":%d,"position":[%d],"note":[[%s]]}'
shapes = [b"[%s,\n%s]", b"%s\n%s\n", b'{"keys":[%s,%s],"closed":false}', b'{"curves":[{"id":1,"keys":[%s,%s]}],"n":[]}']

A = b'{"t":0,"x":1}'
B = b'{"t":1,"x":2}'

accepted_inputs = [
    ("[%s,%s]" % (A.decode(), B.decode())).encode("utf-16"), ("%s\n%s" % (A.decode(), B.decode())).encode("utf-32"),
    b"[%s,%s]" % (A, B), b" \t\r\n[%s , %s] \r\n\t" % (A, B), b"\xef\xbb\xbf[%s,%s]" % (A, B),
    b"\xef\xbb\xbf%s\n%s" % (A, B), b"%s\n%s" % (A, B), b"%s\r\n%s\r\n" % (A, B), b"\n\n%s\n\n \n%s\n\n" % (A, B),
    b'{"keys":[%s,%s]}' % (A, B), b'{"rows":[%s,%s]}' % (A, B), b'{"n":[1,{"keys":[]}],"keys":[%s,%s]}' % (A, B),
    b'{"n":"\\u006beys","keys":[%s,%s],"m":"]}"}' % (A, B), b'{"keys":[%s,%s]}\n' % (A, B),
    b'{"curves":[{"keys":[%s,%s]},{"keys":[%s,%s]}]}' % (A, B, A, B), b'\n{"curves" : [ {"keys" : [%s,%s]} ] }\n' % (A, B),
    b'[{"t":0,"x":1,"x\\u0000":2},{"t":1,"x":1,"x\\u0000":2}]', b'[{"\\u0074":0,"\\u0078":1},{"t":1,"x":2}]',
    b"[[%s,%s]]" % (A, B), b'{"k\\u0065ys":[%s,%s]}' % (A, B), b"%s%s\n" % (A, B), b"%s %s\n" % (A, B), b'%s\n{"t":1,\n"x":2}\n' % A, b'[{"t":0,"x":"1"},%s]' % B,
]

refused_inputs = [
    b"", b" ", b"\n", b"[", b"{", b"]", b"}", b"[]", b"{}", b"[[]]", b"null", b"true", b"1", b'"a"', b"[null]", b"[1,2]",
    b'["a"]', b"[true]", b"[%s" % A, b"[%s,%s" % (A, B), b"[%s,%s," % (A, B), b"[%s,%s,]" % (A, B), b"[,%s,%s]" % (A, B),
    b"[%s,,%s]" % (A, B), b"[%s %s]" % (A, B), b"[%s;%s]" % (A, B), b"[%s\n%s]" % (A, B), b"[%s,%s}" % (A, B),
    b"[%s},%s]" % (A, B), b"[%s],%s]" % (A, B), b"[%s,%s]]" % (A, B), b"[%s,%s]}" % (A, B), b"[%s,%s]," % (A, B),
    b"[%s,%s] x" % (A, B), b"[%s,%s]//" % (A, B), b"[%s,%s]\n#" % (A, B), b"[%s,%s][]" % (A, B),
    b"[%s,5,%s]" % (A, B), b"[%s,[],%s]" % (A, B), b'[%s,"a",%s]' % (A, B), b"[%s,\x00%s]" % (A, B),
    b"[%s,%s]\x00" % (A, B), b"\xef\xbb\xbf\xef\xbb\xbf[%s,%s]" % (A, B), b"[\xef\xbb\xbf%s,%s]" % (A, B),
    b"\xff[%s,%s]" % (A, B), b"\xc2\xa0[%s,%s]" % (A, B), b"[%s,\xc2\xa0%s]" % (A, B), b"[%s,\x0c%s]" % (A, B),
    ("[%s,%s]" % (A.decode(), B.decode())).encode("utf-16-be"),
    b"%s,\n%s\n" % (A, B), b"%s\n%s}\n" % (A, B), b"%s\n%s]\n" % (A, B),
    b"%s\n]%s\n" % (A, B), b"%s\n5\n" % A, b"%s\n[]\n" % A, b"%s\n%s\n{" % (A, B),
    b"%s\n//\n%s" % (A, B), b"%s\n#\n%s" % (A, B), b"%s\n%s\n\xff" % (A, B),
    b'{"keys":[%s,%s]' % (A, B), b'{"keys":[%s,%s]]' % (A, B), b'{"keys":[%s,%s],}' % (A, B), b'{"keys":[%s,%s]}}' % (A, B),
    b'{"keys":[%s,%s]} x' % (A, B), b'{"keys":[%s,%s,]}' % (A, B), b'{"keys":[%s,%s}' % (A, B), b'{"keys" [%s,%s]}' % (A, B),
    b'{keys:[%s,%s]}' % (A, B), b"{'keys':[%s,%s]}" % (A, B), b'{"keys":[%s,%s],"keys":[]}' % (A, B),
    b'{"keys":[%s,%s],"keys":1}' % (A, B), b'{,"keys":[%s,%s]}' % (A, B),
    b'{"a":1 "keys":[%s,%s]}' % (A, B), b'{"a":[1,]"keys":[%s,%s]}' % (A, B), b'{"a":01,"keys":[%s,%s]}' % (A, B),
    b'{"keys":[%s,%s],"a":nul}' % (A, B), b'{"keys":[%s,%s],"a":"\t"}' % (A, B), b'{"keys":[%s,%s]:1}' % (A, B),
    b'{"keys":[%s,%s]}{"keys":[%s,%s]}' % (A, B, A, B), b'{"keys":[%s,%s]}\n{"keys":[%s,%s]}' % (A, B, A, B),
    b'{"keys":{"0":%s}}' % A, b'{"keys":5}', b'{"keys":[]}', b'{"curves":[]}', b'{"curves":[5]}', b'{"curves":[[]]}',
    b'{"curves":[{"keys":[%s,%s]}' % (A, B), b'{"curves":[{"keys":[%s,%s]}]' % (A, B), b'{"curves":[{"keys":[%s,%s]},]}' % (A, B),
    b'{"curves":[,{"keys":[%s,%s]}]}' % (A, B), b'{"curves":[{"keys":[%s,%s]} {"keys":[%s,%s]}]}' % (A, B, A, B),
    b'{"curves":[{"keys":[%s,%s]]}' % (A, B), b'{"curves":[{"keys":[%s,%s]}]} x' % (A, B), b'{"curves":[{"keys":[%s,%s]}],}' % (A, B),
    b'{"curves":[{"keys":[%s,%s},]}]}' % (A, B), b'{"curves":[{"keys":[%s,%s]}}' % (A, B),
    b'[{"t":0,"x":1,"x":2},%s]' % B, b'[{"t":0,"x":NaN},%s]' % B, b'[{"t":0,"x":1e400},%s]' % B,
]


def verdict(text):
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        file.write(text)
        file.flush()
        return subprocess.run([program, "--count", "2", file.name], capture_output=True).returncode


def with_value(shape, value):
    return shape % (key % (0, 1, value), key % (1, 2, value))


cases = [(text, 0) for text in accepted_inputs] + [(text, 1) for text in refused_inputs]
for values, expected in ((accepted_values, 0), (refused_values, 1)):
    for number, value in enumerate(values):
        if b"\n" in value:
            cases.append((with_value(shapes[0], value), expected))
        else:
            # Each value has two of the four shapes in turn; all verdicts come from the same parser.
            cases += [(with_value(shapes[(number + i) % len(shapes)], value), expected) for i in (0, 1)]

wrong = [(text, expected, found) for text, expected in cases if (found := verdict(text)) != expected]
for text, expected, found in wrong:
    print(f"exit code {found} instead of {expected}: {text[:200]!r}")
print(f"{len(cases)} inputs, {len(wrong)} wrong verdicts")
sys.exit(1 if wrong else 0)
