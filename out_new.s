cl_f:
.LFB4894:
	pushq	%rbp
	movq	%r8, %r9
	vxorpd	%xmm1, %xmm1, %xmm1
	movq	%rsp, %rbp
	pushq	%r15
	pushq	%r14
	pushq	%r13
	movq	%rdx, %r13
	pushq	%r12
	movq	%rsi, %r12
	movq	%rcx, %rsi
	xorl	%ecx, %ecx
	pushq	%rbx
	movq	%rsi, %rax
	movq	%rdi, %rbx
	movl	$15, %edi
	andq	$-32, %rsp
	subq	$3592, %rsp
	movq	%r12, 1392(%rsp)
	leaq	1352(%rsp), %r14
	leaq	264(%rsp), %r15
	movq	$0x000000000, 1408(%rsp)
	vmovq	.LC14(%rip), %xmm4
	vmovsd	.LC4(%rip), %xmm3
	movl	$15, 1400(%rsp)
	vmovsd	.LC1(%rip), %xmm9
.L99:
	cmpq	%r12, %rcx
	jnb	.L90
	movq	%rcx, %rsi
	movq	%r14, (%rsp)
	vmovss	0(%r13), %xmm8
	xorl	%r11d, %r11d
	salq	$4, %rsi
	vmovss	8(%r13), %xmm7
	vmovss	4(%r13), %xmm6
	xorl	%r8d, %r8d
	vmovss	12(%r13), %xmm5
	addq	%r15, %rsi
	jmp	.L95
.L188:
	vaddsd	%xmm0, %xmm1, %xmm0
.L91:
	vmovss	4(%rbx,%rcx,8), %xmm10
	vmovaps	%xmm10, %xmm1
	vcvtss2sd	%xmm1, %xmm1, %xmm1
	vmovsd	%xmm1, 8(%rsi)
	vandpd	%xmm4, %xmm1, %xmm1
	vcomisd	%xmm1, %xmm3
	jbe	.L170
	vaddsd	%xmm1, %xmm0, %xmm1
.L93:
	xorl	%edx, %edx
	vcomiss	%xmm10, %xmm5
	setb	%dl
	xorl	%r10d, %r10d
	sall	$2, %edx
	vcomiss	%xmm6, %xmm10
	setb	%r10b
	xorl	%r14d, %r14d
	orl	%edx, %r10d
	addl	%r10d, %r10d
	vcomiss	%xmm2, %xmm7
	setb	%r14b
	xorl	%edx, %edx
	sall	$2, %r14d
	vcomiss	%xmm8, %xmm2
	setb	%dl
	addq	$1, %rcx
	addq	$16, %rsi
	orl	%r14d, %edx
	orl	%r10d, %edx
	andl	%edx, %edi
	shlx	%r8, %rdx, %rdx
	addl	$4, %r8d
	orq	%rdx, %r11
	cmpl	$63, %r8d
	ja	.L171
	cmpq	%r12, %rcx
	jnb	.L171
.L95:
	vmovss	(%rbx,%rcx,8), %xmm2
	vmovaps	%xmm2, %xmm0
	vcvtss2sd	%xmm0, %xmm0, %xmm0
	vmovsd	%xmm0, (%rsi)
	vandpd	%xmm4, %xmm0, %xmm0
	vcomisd	%xmm0, %xmm3
	ja	.L188
	vmovsd	%xmm9, %xmm9, %xmm0
	jmp	.L91
.L170:
	vmovsd	%xmm9, %xmm9, %xmm1
	jmp	.L93
.L171:
	movq	(%rsp), %r14
	movl	%edi, 1400(%rsp)
	vmovsd	%xmm1, 1408(%rsp)
	addq	$8, %r14
	movq	%r11, -8(%r14)
	cmpl	$63, %r8d
	ja	.L99
	movq	%rax, %rsi
	jmp	.L98
.L90:
	movq	$0, (%r14)
	movq	%rax, %rsi
.L98:
	vmovsd	264(%rsp), %xmm0
	addq	%r12, %r12
	vcomisd	.LC12(%rip), %xmm1
	vmovsd	%xmm0, 264(%rsp,%r12,8)
	vmovsd	272(%rsp), %xmm0
	vmovsd	%xmm0, 272(%rsp,%r12,8)
	jbe	.L100
	vmovsd	.LC15(%rip), %xmm0
	vcomisd	%xmm1, %xmm0
	jbe	.L100
	testl	%edi, %edi
	jne	.L103
	vmovddup	%xmm1, %xmm1
	movq	1352(%rsp), %rax
	vmovss	4(%r13), %xmm3
	vmulpd	.LC16(%rip), %xmm1, %xmm5
	vmovss	0(%r13), %xmm1
	movl	%eax, %r8d
	movl	%eax, %ebx
	movq	%rax, -8(%rsp)
	vmovss	8(%r13), %xmm2
	andl	$5, %r8d
	andl	$15, %ebx
	movq	1392(%rsp), %r10
	movl	%r8d, %eax
	vunpcklps	%xmm1, %xmm3, %xmm0
	movl	%ebx, -76(%rsp)
	vunpckhpd	%xmm5, %xmm5, %xmm9
	vmovapd	%xmm5, 232(%rsp)
	vcvtps2pd	%xmm0, %xmm7
	vmovss	12(%r13), %xmm0
	negl	%eax
	vunpcklps	%xmm2, %xmm0, %xmm14
	vunpcklps	%xmm0, %xmm2, %xmm4
	vmovapd	%xmm7, -56(%rsp)
	vunpcklps	%xmm0, %xmm1, %xmm0
	vunpcklps	%xmm3, %xmm2, %xmm2
	vunpcklps	%xmm3, %xmm1, %xmm1
	sbbl	%r14d, %r14d
	vmovlhps	%xmm2, %xmm1, %xmm1
	vmovlhps	%xmm4, %xmm0, %xmm0
	vcvtps2pd	%xmm14, %xmm14
	vmovapd	%xmm7, 200(%rsp)
	vcvtps2pd	%xmm1, %ymm1
	vcvtps2pd	%xmm0, %ymm0
	andl	$12, %r14d
	xorl	%r15d, %r15d
	vmovapd	%ymm1, 136(%rsp)
	vmovapd	%ymm0, 168(%rsp)
	vmovapd	%xmm14, 216(%rsp)
	testq	%r10, %r10
	je	.L137
	movl	%r8d, -80(%rsp)
	xorl	%edx, %edx
	xorl	%eax, %eax
	leaq	_ZN3irg6detail12edge_outputsE(%rip), %r11
	leaq	264(%rsp), %rbx
	movq	%rsi, -112(%rsp)
	vmovddup	.LC1(%rip), %xmm6
	movq	%rbx, (%rsp)
	leaq	1416(%rsp), %rbx
	movq	$0, -72(%rsp)
	movq	%rbx, -64(%rsp)
	movq	%r9, -120(%rsp)
.L121:
	movq	-72(%rsp), %rbx
	movq	%r10, %rcx
	movl	$16, %esi
	movl	-76(%rsp), %r8d
	subq	%rbx, %rcx
	cmpq	%rsi, %rcx
	cmovbe	%rcx, %rsi
	cmpq	%rcx, %rsi
	jnb	.L107
	shrq	$4, %rbx
	movq	1360(%rsp,%rbx,8), %r8
	andl	$15, %r8d
.L107:
	movq	-8(%rsp), %rbx
	leaq	-4(,%rsi,4), %rcx
	shlx	%rcx, %r8, %rcx
	movq	%rbx, %r8
	shrq	$4, %r8
	orq	%r8, %rcx
	movq	%rcx, %r9
	movq	%rcx, -16(%rsp)
	movq	%rbx, %rcx
	xorq	%r9, %rcx
	movq	%rcx, %r8
	shrq	$2, %r8
	orq	%rcx, %r8
	movq	%rbx, %rcx
	shrq	$2, %rcx
	movq	%r8, %r9
	orq	%rbx, %rcx
	shrq	%r9
	andn	%r9, %rcx, %rbx
	movl	$16, %ecx
	orq	%r8, %rbx
	subq	%rsi, %rcx
	movabsq	$1229782938247303441, %rsi
	salq	$2, %rcx
	shrx	%rcx, %rsi, %rsi
	andq	%rsi, %rbx
	je	.L138
	movq	-72(%rsp), %rsi
	movq	%r10, -88(%rsp)
	xorl	%ecx, %ecx
	vxorpd	%xmm13, %xmm13, %xmm13
	vpermilpd	$0, %xmm5, %xmm7
	vxorpd	%xmm12, %xmm12, %xmm12
	leaq	_ZN3irg6detail10edge_kindsE(%rip), %r12
	vmovapd	%xmm5, -104(%rsp)
	addq	%rsi, %rsi
	vmovapd	%xmm7, -40(%rsp)
	vmovddup	.LC11(%rip), %xmm10
	movq	%rsi, -24(%rsp)
.L118:
	xorl	%r9d, %r9d
	tzcntq	%rbx, %r9
	shrx	%r9, -8(%rsp), %rsi
	andl	$15, %esi
	orq	%rcx, %rsi
	shrx	%r9, -16(%rsp), %rcx
	salq	$4, %rcx
	movzbl	%cl, %ecx
	shrq	%r9
	orq	%rcx, %rsi
	movq	-24(%rsp), %rcx
	movsbq	4(%r12,%rsi,8), %r8
	addq	%rcx, %r9
	leaq	2(%r9), %r13
	movq	%r13, %rcx
	subq	%rdx, %rcx
	andq	%rcx, %r8
	leaq	(%rax,%r8), %r10
	leaq	8(%r10), %rcx
	cmpq	$272, %rcx
	ja	.L182
	movq	(%rsp), %rcx
	leaq	(%rcx,%rdx,8), %rdx
	movq	-64(%rsp), %rcx
	leaq	(%rcx,%rax,8), %rax
	xorl	%ecx, %ecx
.L110:
	addq	$8, %rcx
	vmovupd	(%rdx), %xmm3
	addq	$64, %rax
	addq	$64, %rdx
	vmovupd	-48(%rdx), %xmm2
	vmovupd	-32(%rdx), %xmm1
	vmovupd	-16(%rdx), %xmm0
	vmovupd	%xmm3, -64(%rax)
	vmovupd	%xmm2, -48(%rax)
	vmovupd	%xmm1, -32(%rax)
	vmovupd	%xmm0, -16(%rax)
	cmpq	%r8, %rcx
	jb	.L110
	movzbl	(%r12,%rsi,8), %eax
	vmovddup	.LC7(%rip), %xmm0
	vmovdqu	136(%rsp,%rax,8), %xmm4
	movq	(%rsp), %rax
	leaq	(%rax,%r9,8), %rax
	movl	$0, %r9d
	vmovupd	(%rax), %xmm3
	vmovupd	16(%rax), %xmm1
	xorl	%eax, %eax
	vsubpd	%xmm3, %xmm1, %xmm2
	vsubpd	%xmm3, %xmm4, %xmm5
	vpermilpd	$1, %xmm3, %xmm3
	vsubpd	%xmm4, %xmm1, %xmm1
	vdivpd	%xmm2, %xmm0, %xmm0
	vpermilpd	$1, %xmm2, %xmm7
	vmovapd	%xmm2, 8(%rsp)
	vmulpd	%xmm5, %xmm7, %xmm8
	vmovapd	%xmm5, 40(%rsp)
	vandpd	%xmm10, %xmm1, %xmm1
	vandpd	%xmm10, %xmm5, %xmm5
	vminpd	%xmm1, %xmm5, %xmm1
	vmovapd	-40(%rsp), %xmm5
	vcmpeqpd	%xmm12, %xmm7, %xmm7
	vmulpd	%xmm8, %xmm0, %xmm0
	vaddpd	%xmm0, %xmm3, %xmm3
	vmovapd	%xmm3, 72(%rsp)
	vmovsd	72(%rsp), %xmm0
	vsubsd	%xmm9, %xmm0, %xmm3
	vaddsd	%xmm9, %xmm0, %xmm2
	vaddsd	%xmm13, %xmm0, %xmm0
	vcvtsd2ss	%xmm3, %xmm3, %xmm3
	vcvtsd2ss	%xmm2, %xmm2, %xmm2
	vcvtsd2ss	%xmm0, %xmm0, %xmm0
	vucomiss	%xmm2, %xmm3
	vmovsd	80(%rsp), %xmm2
	vsubsd	%xmm9, %xmm2, %xmm15
	vaddsd	%xmm9, %xmm2, %xmm3
	vaddsd	%xmm13, %xmm2, %xmm2
	setnp	%al
	cmovne	%r9, %rax
	xorl	%ecx, %ecx
	vcvtsd2ss	%xmm15, %xmm15, %xmm15
	vcvtsd2ss	%xmm3, %xmm3, %xmm3
	vcvtsd2ss	%xmm2, %xmm2, %xmm2
	negq	%rax
	vunpcklps	%xmm2, %xmm0, %xmm0
	vcvtps2pd	%xmm0, %xmm0
	vsubpd	-56(%rsp), %xmm0, %xmm11
	vsubpd	%xmm0, %xmm14, %xmm8
	vminpd	%xmm8, %xmm11, %xmm2
	vucomiss	%xmm3, %xmm15
	vunpcklpd	%xmm8, %xmm11, %xmm8
	vmovmskpd	%xmm8, %edx
	vandpd	%xmm10, %xmm2, %xmm2
	setnp	%cl
	vminpd	%xmm2, %xmm1, %xmm2
	vpermilpd	$1, %xmm6, %xmm1
	cmovne	%r9, %rcx
	vcmpeqpd	%xmm1, %xmm0, %xmm1
	vcmpeqpd	%xmm6, %xmm4, %xmm6
	negq	%rcx
	vcmpltpd	%xmm2, %xmm5, %xmm2
	vmovq	%rax, %xmm5
	vpinsrq	$1, %rcx, %xmm5, %xmm3
	movzbl	1(%r12,%rsi,8), %ecx
	vandpd	%xmm6, %xmm1, %xmm1
	vpor	%xmm7, %xmm3, %xmm3
	vpandn	%xmm2, %xmm1, %xmm1
	vpand	%xmm1, %xmm3, %xmm1
	vmovmskpd	%xmm1, %eax
	vaddpd	%xmm4, %xmm12, %xmm1
	andn	%ecx, %eax, %eax
	orl	%eax, %edi
	movzwl	2(%r12,%rsi,8), %eax
	leaq	0(,%r10,8), %rsi
	addl	%r14d, %eax
	addl	%edx, %eax
	cmpl	$12, %r14d
	movl	%eax, %eax
	cmove	%edx, %r15d
	blsr	%rbx, %rcx
	movzbl	(%r11,%rax,8), %edx
	movzbl	5(%r11,%rax,8), %r14d
	vmovhpd	136(%rsp,%rdx,8), %xmm1, %xmm7
	movzbl	6(%r11,%rax,8), %edx
	vmovupd	%xmm7, 1416(%rsp,%r10,8)
	testb	%dl, %dl
	jne	.L112
.L115:
	movq	%rcx, %rbx
	xorl	%ecx, %ecx
.L113:
	movzbl	2(%r11,%rax,8), %edx
	vunpcklpd	%xmm0, %xmm4, %xmm1
	vunpckhpd	%xmm4, %xmm0, %xmm0
	addq	%r10, %rdx
	vmovupd	%xmm1, 1416(%rsp,%rdx,8)
	movzbl	3(%r11,%rax,8), %edx
	movzbl	4(%r11,%rax,8), %eax
	addq	%r10, %rdx
	vmovupd	%xmm0, 1416(%rsp,%rdx,8)
	addq	%r10, %rax
	je	.L116
	vmovupd	1400(%rsp,%rax,8), %xmm6
	testq	%rbx, %rbx
	je	.L172
.L117:
	movq	%r13, %rdx
	jmp	.L118
.L116:
	vmovapd	1416(%rsp), %xmm6
	testq	%rbx, %rbx
	jne	.L117
.L172:
	movq	-88(%rsp), %r10
	vmovapd	-104(%rsp), %xmm5
.L108:
	addq	$16, -72(%rsp)
	movq	-72(%rsp), %rbx
	cmpq	%r10, %rbx
	jnb	.L189
	movq	%rbx, %rdx
	shrq	$4, %rdx
	movq	1352(%rsp,%rdx,8), %rbx
	movq	%r13, %rdx
	movq	%rbx, -8(%rsp)
	jmp	.L121
.L189:
	leaq	-1(%r10), %rdx
	movl	-80(%rsp), %r8d
	movq	-112(%rsp), %rsi
	movq	%rdx, %rcx
	andl	$15, %edx
	movq	-120(%rsp), %r9
	shrq	$4, %rcx
	salq	$2, %rdx
	movq	1352(%rsp,%rcx,8), %rcx
	shrx	%rdx, %rcx, %rdx
	xorl	%ecx, %ecx
	andl	$15, %edx
	leaq	(%r10,%r10), %rdx
	sete	%cl
	subq	%r13, %rdx
	negq	%rcx
	andq	%rdx, %rcx
	movq	%rcx, %r10
	leaq	(%rcx,%rax), %rcx
	leaq	8(%rcx), %rdx
	cmpq	$272, %rdx
	jbe	.L105
.L182:
	vzeroupper
.L100:
	movq	$-1, %rcx
.L89:
	leaq	-40(%rbp), %rsp
	movq	%rcx, %rax
	popq	%rbx
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	popq	%rbp
	ret
.L112:
	testb	$4, %dl
	jne	.L182
	leaq	16(%r10), %r8
	cmpq	$272, %r8
	ja	.L182
	testb	$2, %dl
	jne	.L190
.L114:
	andl	$1, %edx
	je	.L115
	movl	$256, %ecx
	jmp	.L113
.L190:
	movzbl	1(%r11,%rax,8), %r8d
	vmovhpd	136(%rsp,%r8,8), %xmm1, %xmm7
	vmovupd	%xmm7, 1432(%rsp,%rsi)
	jmp	.L114
.L138:
	movq	%rdx, %r13
	jmp	.L108
.L184:
	vzeroupper
.L103:
	xorl	%ecx, %ecx
	jmp	.L89
.L137:
	xorl	%eax, %eax
	xorl	%ecx, %ecx
	xorl	%r13d, %r13d
.L105:
	leaq	1416(%rsp), %rdx
	leaq	264(%rsp,%r13,8), %r11
	xorl	%ebx, %ebx
	leaq	(%rdx,%rax,8), %rax
.L123:
	addq	$8, %rbx
	vmovupd	(%r11), %xmm3
	addq	$64, %rax
	vmovupd	16(%r11), %xmm2
	vmovupd	32(%r11), %xmm1
	vmovupd	48(%r11), %xmm0
	addq	$64, %r11
	vmovupd	%xmm3, -64(%rax)
	vmovupd	%xmm2, -48(%rax)
	vmovupd	%xmm1, -32(%rax)
	vmovupd	%xmm0, -16(%rax)
	cmpq	%r10, %rbx
	jb	.L123
	testl	%edi, %edi
	jne	.L182
	testl	%r8d, %r8d
	je	.L124
	movl	-76(%rsp), %eax
	leal	320(%r14,%r15), %edi
	shrl	%eax
	andl	$2, %eax
	vmovdqa	136(%rsp,%rax,8), %xmm0
	leaq	_ZN3irg6detail12edge_outputsE(%rip), %rax
	testb	$4, 6(%rax,%rdi,8)
	jne	.L182
	vxorpd	%xmm1, %xmm1, %xmm1
	movzbl	(%rax,%rdi,8), %r8d
	vaddpd	%xmm1, %xmm0, %xmm0
	vmovhpd	136(%rsp,%r8,8), %xmm0, %xmm7
	movzbl	1(%rax,%rdi,8), %r8d
	movzbl	4(%rax,%rdi,8), %eax
	vmovupd	%xmm7, 1416(%rsp,%rcx,8)
	vmovhpd	136(%rsp,%r8,8), %xmm0, %xmm7
	vmovupd	%xmm7, 1432(%rsp,%rcx,8)
	addq	%rax, %rcx
.L124:
	cmpq	$2, %rcx
	jbe	.L184
	vmovsd	1416(%rsp), %xmm1
	vmovsd	1424(%rsp), %xmm0
	jmp	.L125
.L191:
	vucomisd	-8(%rdx,%rcx,8), %xmm0
	jp	.L126
	jne	.L126
	subq	$2, %rcx
	cmpq	$2, %rcx
	jbe	.L126
.L125:
	vucomisd	-16(%rdx,%rcx,8), %xmm1
	jp	.L126
	je	.L191
.L126:
	cmpq	$5, %rcx
	jbe	.L184
	shrq	%rcx
	testq	%r9, %r9
	je	.L186
	vxorps	%xmm2, %xmm2, %xmm2
	xorl	%eax, %eax
	jmp	.L132
.L133:
	addq	$16, %rdx
	cmpq	%rax, %rcx
	jle	.L186
.L132:
	vcvtsd2ss	8(%rdx), %xmm2, %xmm1
	vcvtsd2ss	(%rdx), %xmm2, %xmm0
	vunpcklps	%xmm1, %xmm0, %xmm0
	vmovlps	%xmm0, (%rsi,%rax,8)
	addq	$1, %rax
	cmpq	%r9, %rax
	jne	.L133
.L186:
	vzeroupper
	jmp	.L89
.LFE4894:
	.globl	codes
